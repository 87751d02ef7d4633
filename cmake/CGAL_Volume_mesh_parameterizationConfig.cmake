include(${CMAKE_CURRENT_LIST_DIR}/CGAL_Volume_mesh_parameterizationDependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/CGAL_Volume_mesh_parameterizationTargets.cmake)

# Searched with -I, hence before CGAL's own headers, which are searched with -isystem.
set_target_properties(CGAL::Volume_mesh_parameterization PROPERTIES IMPORTED_NO_SYSTEM TRUE)
