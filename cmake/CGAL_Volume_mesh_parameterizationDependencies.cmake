# What the headers need; read by the build of this package and by projects that use the installed one.
include(CMakeFindDependencyMacro)
find_dependency(CGAL)
find_dependency(Eigen3) # 3.3 or newer; asking for that version would refuse version 5
include(CGAL_Eigen3_support)

# All optional: threads, the faster direct solver, and several processes.
find_package(TBB QUIET)
include(CGAL_TBB_support)
include(${CMAKE_CURRENT_LIST_DIR}/CGAL_CHOLMOD_support.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/CGAL_PETSc_support.cmake)
