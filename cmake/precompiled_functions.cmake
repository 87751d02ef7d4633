# The functions of the precompiled headers, which Clang compiles once: programs that use the headers link the target
# precompiled_functions, and the linker leaves out what they do not call.
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
target_link_options(precompiled_functions INTERFACE LINKER:--gc-sections)
