# Makes the programs of this project compile faster: by one set of precompiled headers and, on demand, by optimizing the
# engine only.
set(CMAKE_OPTIMIZE_DEPENDENCIES ON) # libraries that link others do not wait for them

if(${PROJECT_NAME}_COMPILE_FAST)
  # The linker takes the first of the functions that a program compiles, too: those of the engines are optimized.
  foreach(engine ${PROJECT_NAME}_engine CGAL_Polycube_meshing_3_engine)
    target_compile_options(${engine} PRIVATE -O1)
    target_link_options(${engine} INTERFACE
      "$<BUILD_INTERFACE:LINKER:--whole-archive,$<TARGET_FILE:${engine}>,--no-whole-archive>")
  endforeach()
  # Compiles what the units of both engines share once; the sparse solvers have Eigen by another name.
  set_target_properties(${PROJECT_NAME}_engine PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/sparse_systems.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  file(CONFIGURE OUTPUT empty_engine.cpp CONTENT "")
  set_target_properties(CGAL_Polycube_meshing_3_engine PROPERTIES SOURCES ${CMAKE_CURRENT_BINARY_DIR}/empty_engine.cpp)
  target_sources(${PROJECT_NAME}_engine PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/polycube_engine.cpp)
  target_compile_definitions(${PROJECT_NAME}_engine PRIVATE CGAL_POLYCUBE_MESHING_3_COMPILED_ENGINE)
endif()

# The headers of CGAL, Eigen and Boost that nearly every program includes take most of the compiler's time.
if(TARGET CGAL::Volume_mesh_parameterization_engine AND TARGET CGAL::Data)
  file(CONFIGURE OUTPUT precompiled_headers.cpp CONTENT "")
  add_library(precompiled_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/precompiled_headers.cpp)
  target_link_libraries(precompiled_headers PRIVATE CGAL::Volume_mesh_parameterization_engine CGAL::Data)
  if(NOT ${PROJECT_NAME}_COMPILE_FAST)
    target_precompile_headers(precompiled_headers PRIVATE
      <CGAL/Exact_predicates_inexact_constructions_kernel.h> <CGAL/Labeled_mesh_domain_3.h>
      <CGAL/Mesh_complex_3_in_triangulation_3.h> <CGAL/Mesh_triangulation_3.h> <CGAL/Surface_mesh.h>
      <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h> <Eigen/Dense>
      <boost/property_map/function_property_map.hpp> <iostream> <unordered_map>)
  elseif(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    target_precompile_headers(precompiled_headers PRIVATE cmake/common_instantiations.h)
  else()
    # Clang records each expansion of a macro, of which CGAL's headers have 18 million: each unit would read half a gigabyte.
    # The headers are preprocessed before, which keeps the definitions of macros.
    set_source_files_properties(cmake/common_instantiations.h PROPERTIES LANGUAGE CXX)
    add_library(preprocessed_headers OBJECT cmake/common_instantiations.h)
    target_link_libraries(preprocessed_headers PRIVATE CGAL::Volume_mesh_parameterization_engine CGAL::Data)
    target_compile_options(preprocessed_headers PRIVATE -E -dD)
    set(header ${CMAKE_CURRENT_BINARY_DIR}/preprocessed_headers.h) # a file of a command, so that what includes it is made anew
    add_custom_command(OUTPUT ${header} VERBATIM DEPENDS preprocessed_headers $<TARGET_OBJECTS:preprocessed_headers>
      COMMAND ${CMAKE_COMMAND} -E copy $<TARGET_OBJECTS:preprocessed_headers> ${header})
    target_sources(precompiled_headers PRIVATE ${header})
    target_precompile_headers(precompiled_headers PRIVATE ${header})
  endif()
endif()

# The functions of the precompiled headers are compiled once by Clang. Programs that use the headers link the target
# precompiled_functions; the linker leaves out the functions that they do not call.
if(${PROJECT_NAME}_COMPILE_FAST AND TARGET precompiled_headers AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  target_compile_options(precompiled_headers PRIVATE "SHELL:-Xclang -fmodules-codegen")
  string(TOUPPER "${CMAKE_BUILD_TYPE}" configuration)
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${configuration}}")
  get_directory_property(options COMPILE_OPTIONS)
  set(functions ${CMAKE_CURRENT_BINARY_DIR}/precompiled_functions.o)
  add_custom_command(OUTPUT ${functions} VERBATIM DEPENDS precompiled_headers $<TARGET_OBJECTS:precompiled_headers>
    COMMAND ${CMAKE_CXX_COMPILER} ${flags} ${options} -w
      -c ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/precompiled_headers.dir/cmake_pch.hxx.pch -o ${functions})
  set_source_files_properties(${functions} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
  add_library(precompiled_functions STATIC ${functions})
  set_target_properties(precompiled_functions PROPERTIES LINKER_LANGUAGE CXX)
  target_link_options(precompiled_functions INTERFACE LINKER:--gc-sections,-O0)
endif()
