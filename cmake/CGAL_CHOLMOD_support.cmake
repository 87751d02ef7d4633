# Defines the target CGAL::CHOLMOD_support if CHOLMOD (of SuiteSparse) is found.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY)

if(CHOLMOD_INCLUDE_DIR AND CHOLMOD_LIBRARY AND NOT TARGET CGAL::CHOLMOD_support)
  add_library(CGAL::CHOLMOD_support INTERFACE IMPORTED GLOBAL)
  target_compile_definitions(CGAL::CHOLMOD_support INTERFACE CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD)
  target_include_directories(CGAL::CHOLMOD_support INTERFACE "${CHOLMOD_INCLUDE_DIR}")
  target_link_libraries(CGAL::CHOLMOD_support INTERFACE "${CHOLMOD_LIBRARY}")
endif()
