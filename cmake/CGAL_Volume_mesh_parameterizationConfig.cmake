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

if(TARGET CGAL::Volume_mesh_parameterization_engine AND NOT TARGET CGAL::TBB_support)
  get_target_property(is_built_with_tbb CGAL::Volume_mesh_parameterization_engine IS_BUILT_WITH_TBB)
  if(is_built_with_tbb)
    set(${CMAKE_FIND_PACKAGE_NAME}_FOUND FALSE)
    string(CONCAT ${CMAKE_FIND_PACKAGE_NAME}_NOT_FOUND_MESSAGE "The installed engine was built with TBB, which is not found "
      "here: install TBB, or install the package with CGAL_Volume_mesh_parameterization_ENGINE=OFF.")
  endif()
endif()
