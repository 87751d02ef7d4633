# Defines the target CGAL::Volume_mesh_parameterization_PETSc, for meshes that several processes share, if PETSc and MPI
# are found.
find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(PETSC QUIET PETSc>=3.18)
  find_package(MPI QUIET COMPONENTS CXX)
endif()

if(PETSC_FOUND AND MPI_CXX_FOUND AND NOT TARGET CGAL::Volume_mesh_parameterization_PETSc)
  add_library(CGAL::Volume_mesh_parameterization_PETSc INTERFACE IMPORTED GLOBAL)
  target_include_directories(CGAL::Volume_mesh_parameterization_PETSc INTERFACE ${PETSC_INCLUDE_DIRS})
  target_link_libraries(CGAL::Volume_mesh_parameterization_PETSc INTERFACE
    CGAL::Volume_mesh_parameterization ${PETSC_LINK_LIBRARIES} MPI::MPI_CXX)
endif()
