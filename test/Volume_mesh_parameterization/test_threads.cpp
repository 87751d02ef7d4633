// Several threads call the package at once, each for its own mesh: nothing is shared, and results are those of one thread.
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <array>
#include <cstddef>
#include <thread>
#include <vector>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Points = std::vector<std::array<double, 3> >;

namespace {

// The images of a cube in a ball, with refinement and the search that it needs, and the hexahedra of a bent one.
struct Results
{
  Points images, hexahedra;

  Results()
  {
    VMP::Tetrahedron_soup_3 cube = source_soup(cube_mesh(3));
    Points targets;
    VMP::Ball_boundary_parameterizer_3().parameterize(cube.points, cube.cells, targets);
    CGAL::stretch_minimizing_volume_parameterization(cube, targets, images,
                                                     CGAL::parameters::refinement_mode(VMP::Refinement_mode::HELPFUL));

    VMP::Tetrahedron_soup_3 bent = source_soup(cube_mesh(3));
    for(std::array<double, 3>& p : bent.points)
      p[2] += 0.1 * p[0] * p[0];
    Points images_of_bent;
    PM::Hexahedron_soup_3 mesh;
    PM::Polycube_boundary_parameterizer_3(1).parameterize(bent.points, bent.cells, targets);
    CGAL::stretch_minimizing_volume_parameterization(bent, targets, images_of_bent);
    PM::make_hexahedral_mesh_3(bent, images_of_bent, 1, mesh);
    hexahedra = mesh.points;
  }
};

} // namespace

TEST_CASE("Six threads at once find what one finds")
{
  const Results expected;
  REQUIRE(expected.images.size() >= 64);
  REQUIRE(expected.hexahedra.size() >= 64);
  std::vector<Results> found(6, expected);
  std::vector<std::thread> threads;
  for(Results& results : found)
    threads.emplace_back([&results] { results = Results(); });
  for(std::thread& thread : threads)
    thread.join();
  for(const Results& results : found)
  {
    CHECK(results.images == expected.images);
    CHECK(results.hexahedra == expected.hexahedra);
  }
}
