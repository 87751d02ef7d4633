# Holds what the tests of both packages share.
find_package(Catch2 REQUIRED)
add_library(catch_main OBJECT test/Volume_mesh_parameterization/catch_main.cpp)
target_include_directories(catch_main PUBLIC test/Volume_mesh_parameterization)
target_link_libraries(catch_main PUBLIC Catch2::Catch2)

# The tests link the engine, if it is there; a project that uses the installed package is header-only.
set(package CGAL::Polycube_meshing_3)
if(TARGET CGAL::Polycube_meshing_3_engine)
  set(package CGAL::Polycube_meshing_3_engine)
endif()

# Adds a test for each of some files. It is a program of its own, or, in less time, one with the others of a list that `groups`
# names. The variable program_of_NAME holds the program.
function(add_tests) # files
  foreach(source ${ARGN})
    get_filename_component(name ${source} NAME_WE)
    set(program ${name})
    foreach(group ${groups})
      if(${PROJECT_NAME}_COMPILE_FAST AND name IN_LIST ${group})
        set(program ${group})
      endif()
    endforeach()
    set(program_of_${name} ${program} PARENT_SCOPE)
    if(TARGET ${program})
      target_sources(${program} PRIVATE ${source})
    else()
      add_executable(${program} ${source})
      set_target_properties(${program} PROPERTIES UNITY_BUILD ${${PROJECT_NAME}_COMPILE_FAST} UNITY_BUILD_BATCH_SIZE 0)
      if(name STREQUAL test_instruction_sets) # for any processor, as the engine may not be
        target_link_libraries(${program} PRIVATE catch_main CGAL::Volume_mesh_parameterization)
      else()
        target_link_libraries(${program} PRIVATE catch_main ${package} CGAL::Data)
      endif()
      if(TARGET precompiled_headers AND NOT name STREQUAL test_instruction_sets)
        target_precompile_headers(${program} REUSE_FROM precompiled_headers)
        target_link_libraries(${program} PRIVATE $<TARGET_NAME_IF_EXISTS:precompiled_functions>)
      endif()
    endif()
    add_test(NAME ${name} COMMAND ${program} "-#" "[#${name}]")
    set_tests_properties(${name} PROPERTIES FAIL_REGULAR_EXPRESSION "No test cases matched")
  endforeach()
endfunction()
