// Catch2, version 2 or 3.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_CATCH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_CATCH_H

#if __has_include(<catch2/catch_all.hpp>)
#  include <catch2/catch_all.hpp>
#else
#  include <catch2/catch.hpp>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_CATCH_H
