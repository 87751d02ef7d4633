// Coordinates that are stored in a narrower type than double: what is checked is what is stored.
#include "catch.h"
#include "cube_complex.h"
#include "cube_mesh.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

using Eigen::Vector3d;
using VMP::internal::Numbered_mesh_3;
using Float_kernel = CGAL::Simple_cartesian<float>;
using Indices = std::vector<std::array<std::size_t, 4> >;

namespace {

constexpr double spacing = 1. / 512; // of numbers of type float around 20,000
constexpr double offset = 20000;

// Counts the cells that are not positive, by rational numbers. `point(v)` has three coordinates.
template <typename Point>
std::size_t number_of_bad_cells(const Indices& cells, const Point& point)
{
  using Exact_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const auto exact = [&](const std::size_t v)
  {
    const auto p = point(v);
    return Exact_kernel::Point_3(CGAL::Exact_rational(double(p[0])), CGAL::Exact_rational(double(p[1])),
                                 CGAL::Exact_rational(double(p[2])));
  };
  return std::count_if(cells.begin(), cells.end(), [&](const std::array<std::size_t, 4>& c)
  { return CGAL::orientation(exact(c[0]), exact(c[1]), exact(c[2]), exact(c[3])) != CGAL::POSITIVE; });
}

// A cube with a dent, seven times as wide as the spacing for four cells: some fit in, but not where rounding puts them.
Numbered_mesh_3 dented_cube()
{
  constexpr double width = 7.168 * spacing;
  return mapped_cube(4, 0, [&](const Vector3d& p) -> Vector3d
  {
    const double depth = p == Vector3d(2, 2, 4) ? 2 : 0;
    return Vector3d::Constant(offset) + width / 4 * (p - depth * Vector3d::UnitZ());
  });
}

// A cube of n^3 small ones that are a multiple of the spacing wide, with itself as target.
Numbered_mesh_3 cube_of_spacings(const int n, const double factor)
{
  Numbered_mesh_3 mesh = cube_mesh(n);
  mesh.source = (spacing * factor * mesh.source).array() + offset;
  mesh.target = mesh.source;
  return mesh;
}

Eigen::MatrixXd rows(const VMP::internal::Matrix3Xd& columns) { return columns.transpose(); }

// Three numbers of type float, made of a point of double.
struct Float_point
{
  std::array<float, 3> coordinates;

  Float_point() = default;
  Float_point(const Cube_complex<>::Point_3& p) : coordinates{ float(p.x()), float(p.y()), float(p.z()) } {}
  float operator[](const int i) const { return coordinates[i]; }
};

} // namespace

TEST_CASE("Images of a kernel of float are positive as they are stored, and meet the boundary")
{
  Cube_complex<Float_kernel> complex(dented_cube());
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(complex.c3t3), complex.uvw_map(), params::boundary_map(complex.boundary_map()));
  INFO(result.message);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.boundary_residual == 0);
  CHECK(number_of_bad_cells(source_soup(complex.mesh).cells,
                            [&](const std::size_t v) { return complex.uvw.at(complex.vertices[v]); }) == 0);
  for(const auto& [v, p] : complex.target)
    CHECK(complex.uvw.at(v) == p);
}

TEST_CASE("So are images that a property map stores as float")
{
  Cube_complex<> complex(dented_cube());
  std::unordered_map<Cube_complex<>::Vertex_handle, Float_point> images;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(complex.c3t3), boost::make_assoc_property_map(images), params::boundary_map(complex.boundary_map()));
  INFO(result.message);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.boundary_residual == 0);
  CHECK(number_of_bad_cells(source_soup(complex.mesh).cells,
                            [&](const std::size_t v) { return images.at(complex.vertices[v]); }) == 0);
}

TEST_CASE("So are images in a matrix or in arrays of float, and the targets are rounded")
{
  const Numbered_mesh_3 mesh = dented_cube();
  const Indices cells = source_soup(mesh).cells;
  const Eigen::MatrixXd source = rows(mesh.source), targets = rows(mesh.target);
  Eigen::MatrixXf images;
  const VMP::Parameterization_result result
    = CGAL::stretch_minimizing_volume_parameterization(source, cells, targets, images);
  INFO(result.message);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.boundary_residual == 0);
  CHECK(number_of_bad_cells(cells, [&](const std::size_t v) { return images.row(v); }) == 0);
  const int n = mesh.number_of_prescribed_vertices();
  CHECK(images.bottomRows(n) == Eigen::MatrixXf(targets.bottomRows(n).cast<float>()));

  std::vector<std::array<float, 3> > in_arrays;
  CHECK(CGAL::stretch_minimizing_volume_parameterization(source, cells, targets, in_arrays).status == VMP::OK);
  for(std::size_t v = 0; v < in_arrays.size(); ++v)
    CHECK(images.row(v) == Eigen::RowVector3f(in_arrays[v].data()));
}

TEST_CASE("Boundaries that are found or slide are rounded, too")
{
  Eigen::MatrixXf points = rows(cube_mesh(3).source).cast<float>(), images;
  Indices cells = source_soup(cube_mesh(3)).cells;
  const VMP::Parameterization_result ball = CGAL::stretch_minimizing_volume_parameterization(points, cells, images);
  CHECK(ball.status == VMP::OK);
  CHECK(ball.boundary_residual == 0);
  CHECK(number_of_bad_cells(cells, [&](const std::size_t v) { return images.row(v); }) == 0);

  const double side = 0.1; // its multiples are no numbers of type float
  const Numbered_mesh_3 mesh = mapped_cube(3, 0, [&](const Vector3d& p) -> Vector3d
  { return side * p.cwiseProduct(Vector3d::Constant(6) - p); });
  const Eigen::MatrixXd targets = rows(mesh.target);
  cells = source_soup(mesh).cells;
  const VMP::Parameterization_result sliding = CGAL::stretch_minimizing_volume_parameterization(
    rows(mesh.source), cells, targets, images, params::do_slide_boundary(true));
  CHECK(sliding.status == VMP::OK);
  CHECK(sliding.number_of_sliding_vertices > 0);
  CHECK(sliding.boundary_residual == 0);
  CHECK(number_of_bad_cells(cells, [&](const std::size_t v) { return images.row(v); }) == 0);
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    for(int i = 0; i < 3; ++i)
      if(mesh.source(i, v) == 0 || mesh.source(i, v) == 3)
        CHECK(images(v, i) == float(targets(v, i)));
}

TEST_CASE("Where too few numbers are left for the vertices inside, the status and the message say so")
{
  const Numbered_mesh_3 mesh = cube_of_spacings(2, 1); // one point inside
  Eigen::MatrixXd source = rows(cube_mesh(2).source), targets = rows(mesh.target);
  Indices cells = source_soup(mesh).cells;
  REQUIRE(VMP::make_parameterizable(source, cells) > 1); // and more vertices
  targets.conservativeResize(source.rows(), 3);
  Eigen::MatrixXd images;
  CHECK(CGAL::stretch_minimizing_volume_parameterization(source, cells, targets, images).status == VMP::OK);
  Eigen::MatrixXf rounded_images = Eigen::MatrixXf::Ones(1, 3);
  const VMP::Parameterization_result result
    = CGAL::stretch_minimizing_volume_parameterization(source, cells, targets, rounded_images);
  CHECK(result.status == VMP::ERROR_INVERTED_BY_ROUNDING);
  CHECK(!result.has_valid_map);
  CHECK(result.number_of_inverted_cells > 0);
  CHECK(result.message.find(VMP::get_error_message(result.status)) == 0);
  CHECK(result.message.find("the vertex of the source at (") != std::string::npos);
  CHECK(result.message.find(VMP::internal::sentence("spacing of ", spacing)) != std::string::npos);
  CHECK(rounded_images == Eigen::MatrixXf::Ones(1, 3));
}

TEST_CASE("A bound of angles that rounding exceeds is missed")
{
  const Numbered_mesh_3 mesh = dented_cube();
  const Indices cells = source_soup(mesh).cells;
  const Eigen::MatrixXd source = rows(mesh.source), targets = rows(mesh.target).cast<float>().cast<double>();
  Eigen::MatrixXd images;
  const double largest = CGAL::stretch_minimizing_volume_parameterization(source, cells, targets, images).distortion.angle_max;
  const auto bound = params::maximum_angle_distortion(1.001 * largest);
  CHECK(CGAL::stretch_minimizing_volume_parameterization(source, cells, targets, images, bound).status == VMP::OK);
  Eigen::MatrixXf rounded_images;
  const VMP::Parameterization_result result
    = CGAL::stretch_minimizing_volume_parameterization(source, cells, targets, rounded_images, bound);
  CHECK(result.status == VMP::ERROR_ANGLE_BOUND_NOT_REACHED);
  CHECK(result.distortion.angle_max > 1.001 * largest);
  CHECK(result.message.find("Rounding") != std::string::npos);
}

TEST_CASE("Refinement inserts points that make positive cells as they are stored")
{
  for(const int factor : { 1, 3 }) // no point between neighbors is stored, or two
  {
    const Numbered_mesh_3 mesh = cube_of_spacings(3, factor);
    Eigen::MatrixXf points = rows(mesh.source).cast<float>();
    Indices cells = source_soup(mesh).cells;
    const std::size_t number = VMP::make_parameterizable(points, cells);
    CHECK(number_of_bad_cells(cells, [&](const std::size_t v) { return points.row(v); }) == 0);

    Cube_complex<Float_kernel> complex(mesh);
    CHECK(VMP::make_parameterizable(complex.c3t3) == number);
    CHECK((number > 0 || factor == 1));
    for(auto c = complex.c3t3.cells_in_complex_begin(); c != complex.c3t3.cells_in_complex_end(); ++c)
      CHECK(number_of_bad_cells({ { 0, 1, 2, 3 } }, [&](const std::size_t i)
      { return VMP::internal::point_of_vertex(complex.c3t3.triangulation(), c->vertex(int(i))); }) == 0);
  }
}

TEST_CASE("A complex is not built with cells that its kernel flattens")
{
  CHECK_THROWS_AS(Cube_complex<Float_kernel>(cube_of_spacings(2, 0.1)), VMP::Input_error);
  CHECK_NOTHROW(Cube_complex<Float_kernel>(cube_of_spacings(2, 1)));
}
