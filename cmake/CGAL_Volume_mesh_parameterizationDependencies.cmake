# The dependencies of the headers; read by the build of this package and by projects that use the installed one.
include(CMakeFindDependencyMacro)
find_dependency(CGAL)
# 3.3 or newer; asking for that version would refuse version 5. The file that CGAL has for Eigen defines no target Eigen3::Eigen,
# for which users look, who find Eigen after this package.
find_dependency(Eigen3 CONFIG)
include(CGAL_Eigen3_support)

# Compilers without #include_next find CGAL's list of named parameters by a header that names its place.
find_file(CGAL_PARAMETERS_INTERFACE CGAL/STL_Extension/internal/parameters_interface.h HINTS ${CGAL_INCLUDE_DIRS})
mark_as_advanced(CGAL_PARAMETERS_INTERFACE)
set(CGAL_parameters_interface_folder ${CMAKE_CURRENT_BINARY_DIR}/CGAL_parameters_interface)
file(CONFIGURE OUTPUT ${CGAL_parameters_interface_folder}/CGAL_parameters_interface.h
  CONTENT "#include \"${CGAL_PARAMETERS_INTERFACE}\"\n")

# All optional: threads, the faster direct solver, several processes, and compressed files of VTK.
find_package(TBB QUIET)
include(CGAL_TBB_support)
include(${CMAKE_CURRENT_LIST_DIR}/CGAL_CHOLMOD_support.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/CGAL_PETSc_support.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/CGAL_VTU_compression_support.cmake)
