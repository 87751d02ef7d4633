// Hexahedra of bodies, and bodies that have none.
#include "hexahedra_of_bodies.h"

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Features/hexahedra_with_features_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

TEST_CASE("A box of tetrahedra becomes cubes")
{
  const Body box(3, 0.2, same);
  Hexahedron_soup_3 mesh;
  for(const int n : {1, 2})
  {
    const Hexahedral_mesh_result result = box.mesh(1. / n, mesh);
    REQUIRE(result.status == VMP::OK);
    CHECK(result.number_of_cells == static_cast<std::size_t>(27 * n * n * n));
    CHECK(mesh.cells.size() == result.number_of_cells);
    CHECK(mesh.points.size() == static_cast<std::size_t>((3 * n + 1) * (3 * n + 1) * (3 * n + 1)));
    CHECK(result.number_of_vertices - result.number_of_boundary_vertices
          == static_cast<std::size_t>((3 * n - 1) * (3 * n - 1) * (3 * n - 1)));
    CHECK_FALSE(result.has_padding);
    CHECK(result.minimum_scaled_jacobian == Approx(1));
    CHECK(result.mean_scaled_jacobian == Approx(1));
    CHECK(smallest_determinant(mesh) == Approx(1. / (n * n * n)));
    CHECK(enclosed_volume(mesh) == Approx(27));
  }
}

TEST_CASE("The grid has the planes of the domain, whatever the spacing")
{
  Body box(2, 0, same);
  for(std::array<double, 3>& q : box.images) // boxes of 1.5 x 0.7 x 1
    q = { 0.75 * q[0], 0.35 * q[1], 0.5 * q[2] };
  Hexahedron_soup_3 mesh;
  REQUIRE(box.mesh(0.5, mesh).status == VMP::OK);
  CHECK(mesh.cells.size() == 3 * 1 * 2);
  REQUIRE(box.mesh(100, mesh).status == VMP::OK);
  CHECK(mesh.cells.size() == 1);
  CHECK(smallest_determinant(mesh) == Approx(8));
}

TEST_CASE("A bent bar with an L-shaped section becomes hexahedra")
{
  const Body bar = l_shaped_bar();
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = bar.mesh(1, mesh);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.number_of_cells == 4 * 12);
  CHECK(result.minimum_scaled_jacobian > 0.5);
  CHECK(smallest_determinant(mesh) > 0);
  check_boundary(mesh, bar);

  // the edge inside the L, where y = z = 2 in the domain, is an edge of the hexahedra
  for(int x = 0; x <= 4; ++x)
  {
    const Vector3d corner = bent(Vector3d(x, 2, 2));
    CHECK(std::any_of(mesh.points.begin(), mesh.points.end(), [&](const std::array<double, 3>& p)
                      { return (vector(p) - corner).norm() < 1e-12; }));
  }
}

TEST_CASE("A ball gets a layer along its boundary")
{
  const Body ball(8, 0, rounded);
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = ball.mesh(1, mesh);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.has_padding); // otherwise hexahedra along the edges of the cube would have flat corners
  CHECK(result.number_of_cells == 512 + 384);
  CHECK(result.number_of_boundary_vertices == 386);
  CHECK(result.minimum_scaled_jacobian > 0.3);
  CHECK(smallest_determinant(mesh) > 0);
  const std::vector<int> numbers = boundary_quadrangles_of_cells(mesh);
  CHECK(*std::max_element(numbers.begin(), numbers.end()) == 1);
  check_boundary(mesh, ball);
}

TEST_CASE("Cylinders get a layer along their walls alone, which ends on the faces around them")
{
  const std::size_t disc = 8 * 8 * 4, stem = 4 * 4 * 4, wall = 32 * 4, wall_of_stem = 16 * 4, top_of_disc = 8 * 8 - 4 * 4;
  const Body bodies[] = { Body(4, 0, rounded_around_z), disc_with_stem() };
  // The circle where the stem begins is concave: its wall has a layer together with the top of the disc.
  const std::size_t numbers[] = { 8 * 8 * 8 + 2 * wall, disc + stem + wall + wall_of_stem + top_of_disc + 32 };
  for(int i = 0; i < 2; ++i)
  {
    Hexahedron_soup_3 mesh;
    const Hexahedral_mesh_result result = bodies[i].mesh(0.5, mesh);
    REQUIRE(result.status == VMP::OK);
    CHECK(result.has_padding);
    CHECK(result.number_of_cells == numbers[i]);
    CHECK(result.minimum_scaled_jacobian > 0.4); // a quadrangle alone in a straight corner of a circle makes less than 0.2
    CHECK(smallest_determinant(mesh) > 0);
    check_boundary(mesh, bodies[i]);
  }
}

TEST_CASE("Hexahedra do not depend on the number of threads")
{
#ifdef CGAL_LINKED_WITH_TBB
  const Body ball(8, 0, rounded);
  Hexahedron_soup_3 sequential, parallel;
  REQUIRE(ball.mesh(2, sequential).status == VMP::OK);
  REQUIRE(ball.mesh<CGAL::Parallel_tag>(2, parallel).status == VMP::OK);
  CHECK(sequential.points == parallel.points);
  CHECK(sequential.cells == parallel.cells);
#endif
}

namespace {

// Ends a computation when it is asked for the n-th time.
struct Impatient_visitor
{
  std::size_t n, number_of_questions = 0;

  bool after_step(const VMP::Parameterization_step&) { return true; }
  bool goes_on() { return ++number_of_questions != n; }
};

} // namespace

TEST_CASE("Whenever the search for hexahedra is ended, there are none, or valid ones")
{
  const auto ridged = [](const Vector3d& p) -> Vector3d { return { p[0], p[1], p[2] * (1 - 0.2 * std::abs(p[0] - p[1])) }; };
  std::size_t number_without_all_features = 0;
  for(const Body& body : { Body(8, 0, rounded), turned_box(), Body(4, 0, ridged) })
  {
    const auto mesh_until = [&](Impatient_visitor& visitor, Hexahedron_soup_3& mesh)
    {
      return body.mesh(1, mesh, CGAL::parameters::visitor(std::ref(visitor)));
    };
    Impatient_visitor patient = { 0 };
    Hexahedron_soup_3 whole;
    const Hexahedral_mesh_result best = mesh_until(patient, whole);
    REQUIRE(best.status == VMP::OK);
    CHECK_FALSE(best.is_interrupted);
    REQUIRE(patient.number_of_questions > 30);

    bool is_valid = false;
    for(std::size_t n = 1; n <= patient.number_of_questions; n += 1 + n / 5)
    {
      CAPTURE(n);
      Impatient_visitor visitor = { n };
      Hexahedron_soup_3 mesh;
      const Hexahedral_mesh_result result = mesh_until(visitor, mesh);
      CHECK(visitor.number_of_questions == n); // then it is at its end
      CHECK(result.is_interrupted);
      CHECK(result.status == VMP::ERROR_INTERRUPTED);
      CHECK_FALSE(result.message.empty());
      if(result.has_valid_mesh)
      {
        CHECK(smallest_determinant(mesh) > 0);
        CHECK(result.number_of_cells == mesh.cells.size());
        CHECK(result.message.find("Success") == std::string::npos);
        const bool has_all = PM::internal::number_of_kept(result.features) == PM::internal::number_of_features(result.features);
        CHECK(has_all == (result.message.find(" curves and ") == std::string::npos));
        number_without_all_features += !has_all;
        is_valid = true;
      }
      else
      {
        CHECK(mesh.cells.empty());
        CHECK_FALSE(is_valid); // a mesh that is valid once is not lost
      }
    }
    CHECK(is_valid);
  }
  CHECK(number_without_all_features > 0);
}

TEST_CASE("Without time there are no hexahedra")
{
  Cube_complex<> complex(cube_mesh(2, 0));
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    complex.uvw.emplace(complex.vertices[v], complex.vertices[v]->point());
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(complex.c3t3, complex.uvw_map(), 1, mesh,
                                                             CGAL::parameters::maximum_running_time(0.));
  CHECK(result.status == VMP::ERROR_INTERRUPTED);
  CHECK(mesh.cells.empty());
  CHECK(PM::make_hexahedral_mesh_3(complex.c3t3, complex.uvw_map(), 1, mesh).number_of_cells == 8);
}

TEST_CASE("A grid that memory has no room for is refused with a spacing that would do")
{
  const Body box(2, 0, same);
  Hexahedron_soup_3 mesh;
  const auto refused = [&](const double spacing)
  {
    const Hexahedral_mesh_result result = box.mesh(spacing, mesh);
    CHECK(result.status == VMP::ERROR_SIZE_OUT_OF_RANGE);
    return result.message;
  };
  CHECK(refused(2. / 1000).find("1e+09 boxes and may need 4000 GB of memory") != std::string::npos);
  for(const double spacing : {2. / 300, 1e-9, std::numeric_limits<double>::denorm_min()})
  {
    const std::string message = refused(spacing);
    const std::size_t begin = message.find("a spacing of ");
    REQUIRE(begin != std::string::npos);
    const double boxes = std::pow(std::round(2 / std::stod(message.substr(begin + 13))), 3);
    CHECK(boxes <= 1e7);
    CHECK(boxes > 5e6);
  }

  // cubes in a row along the diagonal, whose faces alone are in too many planes
  Body steps(1, 0, same);
  for(int i = 1; i < 250; ++i)
    for(const std::array<double, 3>& p : Points(steps.images.begin(), steps.images.begin() + 8))
    {
      steps.images.push_back({ p[0] + 2 * i, p[1] + 2 * i, p[2] + 2 * i });
      steps.soup.points.push_back(steps.images.back());
    }
  for(std::size_t c = 0; c < 6 * 249; ++c)
  {
    steps.soup.cells.push_back(steps.soup.cells[c]);
    for(std::size_t& v : steps.soup.cells.back())
      v += 8;
  }
  const Hexahedral_mesh_result result = steps.mesh(1e9, mesh);
  CHECK(result.status == VMP::ERROR_SIZE_OUT_OF_RANGE);
  CHECK(result.message.find("of the domain make 1.24251e+08 boxes") != std::string::npos); // 499^3
}

TEST_CASE("What is no box or polycube is named, and nothing is written")
{
  Body box(2, 0, same);
  Hexahedron_soup_3 mesh;
  mesh.points.push_back({ 7, 7, 7 });
  const auto status = [&](const double spacing)
  {
    const Hexahedral_mesh_result result = box.mesh(spacing, mesh);
    CHECK_FALSE(result.message.empty());
    CHECK(mesh.points.size() == 1);
    return result.status;
  };
  CHECK(status(1e-9) == VMP::ERROR_SIZE_OUT_OF_RANGE);
  CHECK_THROWS_AS(status(0), CGAL::Precondition_exception);
  CHECK_THROWS_AS(status(-1), CGAL::Precondition_exception);
  CHECK_THROWS_AS(status(std::numeric_limits<double>::quiet_NaN()), CGAL::Precondition_exception);
  CHECK_THROWS_AS(status(std::numeric_limits<double>::infinity()), CGAL::Precondition_exception);

  const Points images = box.images;
  box.images.back()[0] = std::nextafter(box.images.back()[0], -1.); // on the boundary
  CHECK(status(1) == VMP::ERROR_DOMAIN_NOT_AXIS_PARALLEL);
  box.images.back()[0] = std::numeric_limits<double>::infinity();
  CHECK(status(1) == VMP::ERROR_NON_FINITE_COORDINATE);
  box.images.assign(images.size(), { 0, 0, 0 });
  CHECK(status(1) == VMP::ERROR_INVERTED_TARGET_BOUNDARY);
  box.soup.cells.clear();
  CHECK(status(1) == VMP::ERROR_EMPTY_COMPLEX);

  // the boundary of the body turned inside out: corners on it cannot become positive
  Body mirrored(2, 0, [](const Vector3d& p) { return Vector3d(-p[0], p[1], p[2]); });
  CHECK(mirrored.mesh(1, mesh).status == VMP::ERROR_INVERTED_HEXAHEDRON);
}

TEST_CASE("A body or an image of a size for which numbers have no room is refused, and one that is a point")
{
  Hexahedron_soup_3 mesh;
  const double size = GENERATE(1e-90, 1e110, 1e-160);
  const auto scaled = [&](const Vector3d& p) -> Vector3d { return size * p; };
  const Hexahedral_mesh_result of_body = Body(2, 0, scaled).mesh(1, mesh);
  CHECK(of_body.status == VMP::ERROR_SIZE_OUT_OF_RANGE);
  CHECK(of_body.message.find("bounding box of the source") != std::string::npos);
  Body image(2, 0, same);
  for(std::array<double, 3>& p : image.images)
    p = { size * p[0], size * p[1], size * p[2] };
  const Hexahedral_mesh_result of_image = image.mesh(size, mesh);
  CHECK(of_image.status == VMP::ERROR_SIZE_OUT_OF_RANGE);
  CHECK(of_image.message.find("bounding box of the images") != std::string::npos);
  CHECK(Body(2, 0, [](const Vector3d&) { return Vector3d(1, 2, 3); }).mesh(1, mesh).status
        == VMP::ERROR_INVERTED_SOURCE_CELL);
  CHECK(mesh.points.empty());
}

TEST_CASE("A soup whose arrays do not fit together has no hexahedra")
{
  Body box(1, 0, same);
  Hexahedron_soup_3 mesh;
  box.soup.cell_references.resize(1);
  CHECK_THROWS_AS(PM::make_hexahedral_mesh_3(box.soup, box.images, 1, mesh), VMP::Input_error);
  box.soup.cells[0][0] = box.soup.points.size();
  CHECK_THROWS_AS(box.mesh(1, mesh), VMP::Input_error);
  CHECK(mesh.points.empty());
}

namespace {

using Block_position = std::array<std::size_t, 4>; // a block, and the indices of a cell in it

std::map<Block_position, std::size_t> cells_by_position(const Hexahedron_soup_3& mesh)
{
  std::map<Block_position, std::size_t> result;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    const auto [i, j, k] = mesh.cell_indices[c];
    CHECK(result.emplace(Block_position{ mesh.cell_blocks[c], i, j, k }, c).second);
  }
  return result;
}

} // namespace

TEST_CASE("Hexahedra of a block are a regular grid")
{
  for(const Body& body : { l_shaped_bar(), Body(8, 0, rounded) })
  {
    Hexahedron_soup_3 mesh;
    const bool has_padding = body.mesh(1, mesh).has_padding;
    REQUIRE(mesh.cell_blocks.size() == mesh.cells.size());
    REQUIRE(mesh.cell_indices.size() == mesh.cells.size());
    const std::map<Block_position, std::size_t> cells = cells_by_position(mesh);
    std::map<std::size_t, std::array<std::size_t, 3> > sizes;
    std::map<std::size_t, std::size_t> numbers;
    std::size_t number_of_neighbors = 0;
    for(const auto& [position, c] : cells)
    {
      ++numbers[position[0]];
      for(std::size_t axis = 0; axis < 3; ++axis)
      {
        sizes[position[0]][axis] = (std::max)(sizes[position[0]][axis], position[axis + 1] + 1);
        Block_position behind = position;
        ++behind[axis + 1];
        const auto neighbor = cells.find(behind);
        if(neighbor == cells.end())
          continue;
        ++number_of_neighbors;
        constexpr std::size_t back[3][4] = { {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7} };
        constexpr std::size_t front[3][4] = { {0, 3, 7, 4}, {1, 0, 4, 5}, {0, 1, 2, 3} };
        for(std::size_t i = 0; i < 4; ++i)
          CHECK(mesh.cells[c][back[axis][i]] == mesh.cells[neighbor->second][front[axis][i]]);
      }
    }
    for(const auto& [block, size] : sizes)
      CHECK(numbers[block] == size[0] * size[1] * size[2]);
    CHECK(numbers.size() == (has_padding ? 1 + 6 : 3)); // a cube and its layers, or an L
    CHECK(numbers.begin()->first == 1);
    CHECK(number_of_neighbors == (has_padding ? 3 * 7 * 64 + 6 * 2 * 7 * 8 : 3 * (3 * 4 + 2 * 8)));
  }
}

TEST_CASE("Valid hexahedra with a scaled Jacobian below the bound have a status of their own")
{
  const Body sheared(2, 0, [](const Vector3d& p) -> Vector3d { return { p[0] + 3 * p[1], p[1], p[2] }; });
  Hexahedron_soup_3 mesh;
  const double least = sheared.mesh(1, mesh).minimum_scaled_jacobian;
  REQUIRE(least > 0.01);
  REQUIRE(least < 0.9);
  CHECK(sheared.mesh(1, mesh).status == VMP::OK);
  CHECK(sheared.mesh(1, mesh, CGAL::parameters::minimum_scaled_jacobian(0.99 * least)).status == VMP::OK);
  const Hexahedron_soup_3 expected = mesh;
  mesh = Hexahedron_soup_3();
  const Hexahedral_mesh_result result = sheared.mesh(1, mesh, CGAL::parameters::minimum_scaled_jacobian(1.01 * least));
  CHECK(result.status == VMP::ERROR_POOR_HEXAHEDRON);
  CHECK(result.has_valid_mesh);
  CHECK(mesh.points == expected.points);
  CHECK(result.message.find("has a vertex at (") != std::string::npos);
  // The map is affine: a smaller spacing helps nothing. Squares of the extreme singular values have the sum 11, product 1.
  CHECK(result.message.find("spacing") == std::string::npos);
  CHECK(result.message.find("distorts angles by a factor of 11 at the worst one") != std::string::npos);
  CHECK_THROWS_AS(sheared.mesh(1, mesh, CGAL::parameters::minimum_scaled_jacobian(1.5)), CGAL::Precondition_exception);
}

// Edges of one hexahedron are nearly as long as the body, and its boundary is never farther away.
TEST_CASE("Hexahedra that are too few for the shape of the body are incomplete")
{
  const Body ball(8, 0, rounded);
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result coarse = ball.mesh(8, mesh);
  CAPTURE(coarse.message);
  CHECK(coarse.status == VMP::ERROR_INCOMPLETE_HEXAHEDRA);
  CHECK(coarse.boundary_distance > 1.6); // as for the largest cube in the ball
  CHECK(coarse.message.find("The spacing is 8 in a domain with the sides (8, 8, 8).") != std::string::npos);
  CHECK(ball.mesh(4, mesh).status == VMP::OK);
}
