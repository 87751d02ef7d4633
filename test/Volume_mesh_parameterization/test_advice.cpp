// The advice of each message is carried out, and leads where it says:
// - "Exchange two vertices of each cell", "Scale it", "Use another one" (a linear solver), "needs far less" (memory), "has no
//   limit", "give each set of cells ... a vertex of its own", "Refine the boundary or choose another target", "Exchange opposite
//   faces", "Map the body to a box or a polycube", "Use a spacing of ...", "Make the spacing smaller", "vertices that slide, would
//   help", "prescribe a boundary nearer to the source": here
// - "allow refinement": here for the sentence, in test_arrays.cpp for where it leads, and in test_driver.cpp for --refine
// - "Move one of its targets off the line": in test_entry_function.cpp
// - "Make the spacing smaller" (the spacing of a polycube): in test_polycube.cpp
// - the options of parameterize_mesh_file, its names and examples: in test_driver.cpp; commands of other programs: in
//   check_formats.py and check_interchange.py; options of PETSc: in mpi_tests.cpp
// - "take more processes", "take one with 64-bit indices" (a PETSc): in no test, which would need 2^31 cells
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Eigen_solver_traits_3.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
#  include <CGAL/Volume_mesh_parameterization/CHOLMOD_solver_traits_3.h>
#endif
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

using Cells = std::vector<std::array<std::size_t, 4> >;
using Points = std::vector<std::array<double, 3> >;
using VMP::Tetrahedron_soup_3;

namespace {

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

VMP::Parameterization_result identity(const Tetrahedron_soup_3& soup)
{
  Points images;
  return CGAL::stretch_minimizing_volume_parameterization(soup, soup.points, images);
}

// The unit cubes of [0, n]^3 for which `is_solid` is true.
template <typename IsSolid>
Tetrahedron_soup_3 bricks(const int n, const IsSolid& is_solid)
{
  Tetrahedron_soup_3 soup = source_soup(cube_mesh(n));
  const auto is_hollow = [&](const std::array<std::size_t, 4>& cell)
  {
    std::array<double, 3> center = {};
    for(const std::size_t v : cell)
      for(int i = 0; i < 3; ++i)
        center[i] += soup.points[v][i] / 4;
    return !is_solid(std::floor(center[0]), std::floor(center[1]), std::floor(center[2]));
  };
  soup.cells.erase(std::remove_if(soup.cells.begin(), soup.cells.end(), is_hollow), soup.cells.end());
  soup.cell_references.resize(soup.cells.size());
  return soup;
}

// Gives the cells that are connected by facets around a vertex a copy of it of their own, but for the first ones.
void give_copies(Tetrahedron_soup_3& soup, const std::size_t vertex)
{
  std::vector<std::size_t> left;
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    if(std::count(soup.cells[c].begin(), soup.cells[c].end(), vertex) > 0)
      left.push_back(c);
  const auto share_facet = [&](const std::size_t c, const std::size_t d)
  {
    return std::count_if(soup.cells[c].begin(), soup.cells[c].end(), [&](const std::size_t v)
    { return std::count(soup.cells[d].begin(), soup.cells[d].end(), v) > 0; }) == 3;
  };
  for(bool is_first = true; !left.empty(); is_first = false)
  {
    std::vector<std::size_t> connected = { left.back() };
    left.pop_back();
    for(std::size_t i = 0; i < connected.size(); ++i)
      for(std::size_t j = left.size(); j-- > 0;)
        if(share_facet(connected[i], left[j]))
        {
          connected.push_back(left[j]);
          left.erase(left.begin() + static_cast<std::ptrdiff_t>(j));
        }
    if(is_first)
      continue;
    for(const std::size_t c : connected)
      std::replace(soup.cells[c].begin(), soup.cells[c].end(), vertex, soup.points.size());
    soup.points.push_back(soup.points[vertex]);
  }
}

// Cuts each cell into eight, in the middles of its edges.
Tetrahedron_soup_3 subdivided(const Tetrahedron_soup_3& soup)
{
  Tetrahedron_soup_3 result;
  result.points = soup.points;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  const auto middle = [&](const std::size_t v, const std::size_t w)
  {
    const auto [entry, is_new] = middles.emplace(std::minmax(v, w), result.points.size());
    if(is_new)
    {
      const std::array<double, 3> p = soup.points[v], q = soup.points[w];
      result.points.push_back({ (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2 });
    }
    return entry->second;
  };
  for(const auto& [a, b, c, d] : soup.cells)
  {
    const std::size_t ab = middle(a, b), ac = middle(a, c), ad = middle(a, d), bc = middle(b, c), bd = middle(b, d),
                      cd = middle(c, d);
    for(std::array<std::size_t, 4> cell : Cells{ {a, ab, ac, ad}, {ab, b, bc, bd}, {ac, bc, c, cd}, {ad, bd, cd, d},
                                                 {ac, bd, ab, bc}, {ac, bd, bc, cd}, {ac, bd, cd, ad}, {ac, bd, ad, ab} })
    {
      const auto p = [&](const int i) { return Eigen::Vector3d(result.points[cell[i]].data()); };
      if((p(1) - p(0)).cross(p(2) - p(0)).dot(p(3) - p(0)) < 0)
        std::swap(cell[0], cell[1]);
      result.cells.push_back(cell);
    }
  }
  result.cell_references.resize(result.cells.size());
  return result;
}

// A factorization, which no other solver replaces.
struct Failing_solver : VMP::Eigen_solver_traits_3<>
{
  using Matrix = VMP::Block_sparse_matrix_3<double>;
  VMP::Linear_solver_status status;
  explicit Failing_solver(const VMP::Linear_solver_status status) : status(status) {}
  VMP::Linear_solver_status factorize(const Matrix&) { return status; }
};

std::size_t vertex_at(const Tetrahedron_soup_3& soup, const std::array<double, 3>& p)
{ return static_cast<std::size_t>(std::find(soup.points.begin(), soup.points.end(), p) - soup.points.begin()); }

} // namespace

TEST_CASE("Where two vertices of each cell are exchanged, a source turned inside out is none any more")
{
  Tetrahedron_soup_3 soup = source_soup(cube_mesh(2));
  const auto exchange = [&]
  {
    for(std::array<std::size_t, 4>& cell : soup.cells)
      std::swap(cell[1], cell[3]);
  };
  exchange();
  const VMP::Parameterization_result refused = identity(soup);
  CHECK(refused.status == VMP::ERROR_INVERTED_SOURCE_CELL);
  CHECK(has(refused.message, "Exchange two vertices of each cell"));
  exchange();
  CHECK(identity(soup).status == VMP::OK);
}

TEST_CASE("What is too small or too large is mapped once it is scaled")
{
  const double size = GENERATE(1e-80, 1e80);
  Tetrahedron_soup_3 soup = source_soup(cube_mesh(2));
  const auto scale = [&](const double factor)
  {
    for(std::array<double, 3>& p : soup.points)
      for(double& x : p)
        x *= factor;
  };
  scale(size);
  CHECK(identity(soup).status == VMP::ERROR_SIZE_OUT_OF_RANGE);
  CHECK(has(VMP::get_error_message(VMP::ERROR_SIZE_OUT_OF_RANGE), "Scale it"));
  scale(1 / size);
  CHECK(identity(soup).status == VMP::OK);
}

TEST_CASE("Another linear solver does what one has failed to do")
{
  const Tetrahedron_soup_3 soup = source_soup(cube_mesh(3, 0.1));
  Points images;
  const auto status = GENERATE(VMP::Linear_solver_status::FAILED, VMP::Linear_solver_status::OUT_OF_MEMORY);
  const VMP::Parameterization_result failed = CGAL::stretch_minimizing_volume_parameterization(
    soup, soup.points, images, params::solver_traits(Failing_solver(status)));
  CHECK(failed.status == VMP::ERROR_LINEAR_SOLVER_FAILED);
  CHECK(has(failed.message, "Use another one"));
  CHECK(has(failed.message, "Conjugate_gradient_solver_traits_3 needs far less")
        == (status == VMP::Linear_solver_status::OUT_OF_MEMORY));
  CHECK(CGAL::stretch_minimizing_volume_parameterization(
          soup, soup.points, images, params::solver_traits(VMP::Conjugate_gradient_solver_traits_3<>())).status == VMP::OK);
}

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
TEST_CASE("CHOLMOD comes to the minimum where conjugate gradients are cut at a limit")
{
  const VMP::internal::Numbered_mesh_3 twisted = twisted_cube(4, 0.1);
  const Tetrahedron_soup_3 soup = source_soup(twisted);
  Points targets, images;
  for(int v = 0; v < twisted.number_of_vertices(); ++v)
    targets.push_back({ twisted.target(0, v), twisted.target(1, v), twisted.target(2, v) });
  const auto map_by = [&](const auto& solver)
  { return CGAL::stretch_minimizing_volume_parameterization(soup, targets, images, params::solver_traits(solver)); };
  const VMP::Parameterization_result cut = map_by(VMP::Conjugate_gradient_solver_traits_3<>(1));
  INFO(cut.message);
  CHECK(has(cut.message, "which shortened steps. CHOLMOD_solver_traits_3 has no limit."));
  const VMP::Parameterization_result direct = map_by(VMP::CHOLMOD_solver_traits_3());
  CHECK(direct.status == VMP::OK);
  CHECK(direct.message == VMP::get_error_message(VMP::OK));
  CHECK(direct.number_of_iterations < cut.number_of_iterations);
}
#endif

TEST_CASE("A body that touches itself in an edge is mapped to a ball once cells have copies of its vertices")
{
  // an open ring, seen from above, whose ends touch in the vertical edge at (2, 1)
  Tetrahedron_soup_3 soup = bricks(3, [](const double x, const double y, const double z)
  { return z == 0 && !(x == 1 && y == 1) && !(x == 2 && y == 0); });
  Points targets;
  const VMP::Ball_boundary_parameterizer_3 ball;
  REQUIRE(ball.parameterize(soup.points, soup.cells, targets) == VMP::ERROR_NON_MANIFOLD_BOUNDARY);
  CHECK(has(VMP::get_error_message(VMP::ERROR_NON_MANIFOLD_BOUNDARY),
            "give each set of cells that facets connect a vertex of its own"));
  const std::vector<std::size_t> vertices = VMP::non_manifold_boundary_vertices(soup.points, soup.cells);
  CHECK(vertices.size() == 2);
  for(const std::size_t v : vertices)
    give_copies(soup, v);
  REQUIRE(ball.parameterize(soup.points, soup.cells, targets) == VMP::OK);
  Points images;
  CHECK(CGAL::stretch_minimizing_volume_parameterization(soup, targets, images,
                                                         params::refinement_mode(VMP::Refinement_mode::HELPFUL)).boundary_residual
        == 0);
}

TEST_CASE("A boundary that is too coarse for a cube is mapped once it is refined")
{
  const Tetrahedron_soup_3 cell = { { {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1} }, { {0, 1, 2, 3} }, { 0 }, {}, {} };
  const VMP::Cube_boundary_parameterizer_3 cube;
  Points targets;
  CHECK(cube.parameterize(cell.points, cell.cells, targets) == VMP::ERROR_BOUNDARY_TOO_COARSE);
  const std::string message
    = CGAL::stretch_minimizing_volume_parameterization(cell, targets, params::boundary_parameterizer(cube)).message;
  CHECK((has(message, "around (0.5, 0.5, 0)") || has(message, "around (0.5, 0, 0.5)") || has(message, "around (0, 0.5, 0.5)")));
  const Tetrahedron_soup_3 fine = subdivided(subdivided(cell));
  CHECK(cube.parameterize(fine.points, fine.cells, targets) == VMP::OK);
  for(const VMP::Refinement_mode mode : { VMP::Refinement_mode::HELPFUL, VMP::Refinement_mode::BOUNDARY })
  {
    Tetrahedron_soup_3 split = cell;
    const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
      split.points, split.cells, targets, params::boundary_parameterizer(cube).refinement_mode(mode));
    CHECK((result.status == VMP::OK) == (mode == VMP::Refinement_mode::BOUNDARY));
    CHECK((result.number_of_added_boundary_vertices > 0) == (mode == VMP::Refinement_mode::BOUNDARY));
    CHECK(result.number_of_added_boundary_vertices < 120); // 138 with splits that the edges of the cube do not need
  }
}

std::array<std::size_t, 8> corners_of_cube(const Tetrahedron_soup_3& soup, const double side)
{
  std::array<std::size_t, 8> result;
  for(std::size_t k = 0; k < 8; ++k)
    result[k] = vertex_at(soup, { k & 1 ? side : 0, k & 2 ? side : 0, k & 4 ? side : 0 });
  return result;
}

TEST_CASE("A boundary that is too coarse for corners is fine enough for others")
{
  const Tetrahedron_soup_3 soup = source_soup(cube_mesh(3));
  std::array<std::size_t, 8> corners; // eight of sixteen vertices of one face, side by side
  for(std::size_t k = 0; k < 8; ++k)
    corners[k] = vertex_at(soup, { k & 1 ? 1. : 0., static_cast<double>(k / 2), 0 });
  const VMP::Cube_boundary_parameterizer_3 cube;
  Points targets;
  CHECK(cube.parameterize(soup.points, soup.cells, corners, targets) == VMP::ERROR_BOUNDARY_TOO_COARSE);
  CHECK(has(VMP::get_error_message(VMP::ERROR_BOUNDARY_TOO_COARSE), "Refine the boundary or choose another target"));
  CHECK(cube.parameterize(soup.points, soup.cells, corners_of_cube(soup, 3), targets) == VMP::OK);
}

TEST_CASE("Corners of a mirrored cube fit once opposite faces are exchanged")
{
  const Tetrahedron_soup_3 soup = source_soup(cube_mesh(3));
  std::array<std::size_t, 8> corners = corners_of_cube(soup, 3);
  const auto exchange = [&]
  {
    for(std::size_t k = 0; k < 8; k += 2)
      std::swap(corners[k], corners[k + 1]);
  };
  const VMP::Cube_boundary_parameterizer_3 cube;
  Points targets;
  exchange();
  CHECK(cube.parameterize(soup.points, soup.cells, corners, targets) == VMP::ERROR_MIRRORED_CORNERS);
  CHECK(has(VMP::get_error_message(VMP::ERROR_MIRRORED_CORNERS), "corners 0 and 1, 2 and 3, 4 and 5, 6 and 7"));
  exchange();
  CHECK(cube.parameterize(soup.points, soup.cells, corners, targets) == VMP::OK);
}

TEST_CASE("A body has hexahedra once it is mapped to a box or a polycube")
{
  const Tetrahedron_soup_3 soup = source_soup(cube_mesh(3));
  Points bent = soup.points, targets, images;
  for(std::array<double, 3>& p : bent)
    p[2] += 0.1 * p[0] * p[0];
  PM::Hexahedron_soup_3 hexahedra;
  CHECK(PM::make_hexahedral_mesh_3(bent, soup.cells, bent, 1, hexahedra).status == VMP::ERROR_DOMAIN_NOT_AXIS_PARALLEL);
  CHECK(has(VMP::get_error_message(VMP::ERROR_DOMAIN_NOT_AXIS_PARALLEL), "Map the body to a box or a polycube"));
  const auto np = params::maximum_running_time(1e9);
  REQUIRE(PM::Polycube_boundary_parameterizer_3(1).parameterize(bent, soup.cells, targets, np) == VMP::OK);
  REQUIRE(CGAL::stretch_minimizing_volume_parameterization(bent, soup.cells, targets, images).status == VMP::OK);
  CHECK(PM::make_hexahedral_mesh_3(bent, soup.cells, images, 1, hexahedra).status == VMP::OK);
}

TEST_CASE("A spacing that would do is taken")
{
  const Tetrahedron_soup_3 soup = source_soup(cube_mesh(2));
  const auto hexahedra = [&](const double spacing) // millions of them would take minutes, hence only the grid is checked
  {
    PM::Hexahedron_soup_3 mesh;
    return PM::make_hexahedral_mesh_3(soup.points, soup.cells, soup.points, spacing, mesh, params::maximum_running_time(0.));
  };
  const PM::Hexahedral_mesh_result refused = hexahedra(2. / 300);
  CHECK(refused.status == VMP::ERROR_SIZE_OUT_OF_RANGE);
  const std::string words = "a spacing of ";
  REQUIRE(has(refused.message, words));
  CHECK(hexahedra(std::stod(refused.message.substr(refused.message.find(words) + words.size()))).status == VMP::ERROR_INTERRUPTED);
}

TEST_CASE("Hexahedra that are inverted become positive with a smaller spacing")
{
  const Tetrahedron_soup_3 soup = source_soup(cube_mesh(6));
  Points ring = soup.points; // most of one
  for(std::array<double, 3>& p : ring)
  {
    const double angle = 5 * p[0] / 6, radius = 3 + p[1];
    p = { radius * std::sin(angle), radius * std::cos(angle), p[2] };
  }
  PM::Hexahedron_soup_3 hexahedra;
  const PM::Hexahedral_mesh_result coarse = PM::make_hexahedral_mesh_3(ring, soup.cells, soup.points, 6, hexahedra);
  CHECK(coarse.status == VMP::ERROR_INVERTED_HEXAHEDRON);
  CHECK(has(coarse.message, "Make the spacing smaller"));
  CHECK(PM::make_hexahedral_mesh_3(ring, soup.cells, soup.points, 1, hexahedra).status == VMP::OK);
}

TEST_CASE("Where flat cells hold the energy, vertices that slide help, and so does a boundary with less distortion there")
{
  const Tetrahedron_soup_3 soup = source_soup(cube_mesh(3));
  Points targets = soup.points, images;
  targets[vertex_at(soup, { 1, 1, 0 })] = { 1.99, 1.997, 0 }; // in its face, where two facets are then nearly flat
  const auto map_with = [&](const bool do_slide)
  {
    return CGAL::stretch_minimizing_volume_parameterization(soup, targets, images, params::do_slide_boundary(do_slide));
  };
  const VMP::Parameterization_result fixed = map_with(false);
  INFO(fixed.message);
  CHECK(fixed.status == VMP::ERROR_NOT_CONVERGED);
  CHECK(has(fixed.message, "The cell at (1, 1, 0) has the largest part. A boundary with less distortion there, or vertices "
                           "that slide, would help."));
  CHECK(map_with(true).status == VMP::OK);
  CHECK(map_with(true).energy < 0.01 * fixed.energy);
  targets[vertex_at(soup, { 1, 1, 0 })] = { 1.2, 1.2, 0 };
  CHECK(map_with(false).status == VMP::OK);
}

TEST_CASE("Refinement is no advice where it was allowed, and ends where it brings the boundary no nearer")
{
  const Tetrahedron_soup_3 coarse = source_soup(cube_mesh(2, 0.1));
  Tetrahedron_soup_3 soup = coarse;
  std::mt19937 engine(4); // with other seeds, a few rounds may bring it nearer, each with hundreds of vertices
  Points targets, images;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
  {
    targets.emplace_back();
    for(double& x : targets.back())
      x = static_cast<double>(engine() % 1000);
  }
  const auto np = params::boundary_mode(VMP::Boundary_mode::SOFT).number_of_iterations(100);
  Points nearer = targets;
  for(std::size_t v = 0; v < nearer.size(); ++v)
    for(std::size_t i = 0; i < 3; ++i)
      nearer[v][i] = soup.points[v][i] + 1e-3 * (targets[v][i] - soup.points[v][i]);
  CHECK(has(CGAL::stretch_minimizing_volume_parameterization(coarse, targets, images, np).message,
            "Allow refinement (refinement_mode(Refinement_mode::HELPFUL), for a mesh that is not constant), or prescribe"));
  const VMP::Parameterization_result result
    = CGAL::stretch_minimizing_volume_parameterization(soup, targets, images, np.refinement_mode(VMP::Refinement_mode::HELPFUL));
  INFO(result.message);
  CHECK(result.status == VMP::ERROR_BOUNDARY_NOT_REACHED);
  CHECK(result.number_of_added_vertices > 0);
  CHECK(result.number_of_added_vertices < 1000); // more are allowed
  CHECK_FALSE(has(result.message, "Allow refinement"));
  CHECK(has(result.message, "Prescribe a boundary nearer to the source there."));
  CHECK(CGAL::stretch_minimizing_volume_parameterization(coarse, nearer, images, np).status == VMP::OK);
}
