include(${CMAKE_CURRENT_LIST_DIR}/CGAL_Volume_mesh_parameterizationDependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/CGAL_Volume_mesh_parameterizationTargets.cmake)

# Searched with -I, hence before CGAL's own headers, which are searched with -isystem.
foreach(target Volume_mesh_parameterization Volume_mesh_parameterization_engine)
  if(TARGET CGAL::${target})
    set_target_properties(CGAL::${target} PROPERTIES IMPORTED_NO_SYSTEM TRUE)
  endif()
endforeach()
if(MSVC)
  target_include_directories(CGAL::Volume_mesh_parameterization INTERFACE ${CGAL_parameters_interface_folder})
endif()
