# Defines the target CGAL::CHOLMOD_support if CHOLMOD (of SuiteSparse) is found.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY)

if(CHOLMOD_INCLUDE_DIR AND CHOLMOD_LIBRARY AND NOT TARGET CGAL::CHOLMOD_support)
  set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON) # as the target below
  find_package(CHOLMOD CONFIG QUIET)
  unset(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL)
  add_library(CGAL::CHOLMOD_support INTERFACE IMPORTED GLOBAL)
  target_compile_definitions(CGAL::CHOLMOD_support INTERFACE CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD)
  if(TARGET SuiteSparse::CHOLMOD) # from SuiteSparse 7 on, with the libraries that it needs
    target_link_libraries(CGAL::CHOLMOD_support INTERFACE SuiteSparse::CHOLMOD)
  else()
    target_include_directories(CGAL::CHOLMOD_support INTERFACE "${CHOLMOD_INCLUDE_DIR}")
    target_link_libraries(CGAL::CHOLMOD_support INTERFACE "${CHOLMOD_LIBRARY}")
  endif()
endif()
