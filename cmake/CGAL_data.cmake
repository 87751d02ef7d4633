# Debian ships CGAL's data files as an archive in the documentation of libcgal-demo.
# Unpacks the models that the examples read, unless the data folder is known already.
set(_archive /usr/share/doc/libcgal-dev/data.tar.gz)
if(NOT CGAL_DATA_DIR AND NOT DEFINED ENV{CGAL_DATA_DIR} AND EXISTS ${_archive})
  file(ARCHIVE_EXTRACT INPUT ${_archive} DESTINATION ${PROJECT_BINARY_DIR}
    PATTERNS data/meshes/bull.off data/meshes/elephant.off data/meshes/joint.off)
  set(CGAL_DATA_DIR ${PROJECT_BINARY_DIR}/data)
endif()
