include(CMakeFindDependencyMacro)
find_dependency(CGAL_Volume_mesh_parameterization HINTS ${CMAKE_CURRENT_LIST_DIR}/..)
include(${CMAKE_CURRENT_LIST_DIR}/CGAL_Polycube_meshing_3Targets.cmake)

# As for the package on which this one depends.
foreach(target Polycube_meshing_3 Polycube_meshing_3_engine)
  if(TARGET CGAL::${target})
    set_target_properties(CGAL::${target} PROPERTIES IMPORTED_NO_SYSTEM TRUE)
  endif()
endforeach()
