// The position, the size and the numbering of a body do not decide about its polycube.
#include "bricks.h"

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <vector>

TEST_CASE("the size and the place of the source do not matter")
{
  const double scale = GENERATE(1e-150, 1e150);
  Labelled_complex complex(bricks(size, is_bracket, [&](const double x, const double y, const double z)
  {
    return in_place(scale * x, scale * (y + 100), scale * z);
  }));
  REQUIRE(complex.parameterize() == VMP::OK);
  for(const auto& entry : complex.image)
    for(int axis = 0; axis < 3; ++axis)
      CHECK(std::abs(entry.second[axis] - entry.first->point()[axis]) < 1e-12 * scale);
}

// Body of bricks that are moved, then turned, with its image by arrays.
struct Turned_body
{
  VMP::Tetrahedron_soup_3 soup;
  std::vector<std::array<double, 3> > image;
  PM::Polycube_result result; // of the polycube

  template <typename IsSolid, typename Move>
  Turned_body(const IsSolid& is_solid, const Move& move, const Eigen::Matrix3d& turn)
    : soup(bricks(size, is_solid, [&](const double x, const double y, const double z)
      {
        const std::array<double, 3> p = move(x, y, z);
        const Eigen::Vector3d q = turn * Eigen::Vector3d(p[0], p[1], p[2]);
        return std::array<double, 3>{ q.x(), q.y(), q.z() };
      }))
  {}

  VMP::Error_code parameterize(const PM::Polycube_axes axes, const double spacing = 0)
  {
    return Polycube(spacing, axes, &result).parameterize(soup.points, soup.cells, image);
  }

  Eigen::Vector3d point(const std::size_t v) const { return Eigen::Vector3d(soup.points[v].data()); }
  Eigen::Vector3d image_of(const std::size_t v) const { return Eigen::Vector3d(image[v].data()); }

  Eigen::Matrix3d told() const
  {
    Eigen::Matrix3d rotation;
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 3; ++k)
        rotation(i, k) = result.rotation[i][k];
    return rotation;
  }

  double distortion() const
  {
    const auto surface = VMP::internal::surface_of(VMP::internal::body_of(soup.points, soup.cells));
    return VMP::internal::facet_distortion_3(surface.facets,
                                             [&](const std::size_t v) { return point(surface.vertices[v]); },
                                             [&](const std::size_t v) { return image_of(surface.vertices[v]); });
  }
};

// Returns rotations that are far from all symmetries of the cube.
std::vector<Eigen::Matrix3d> turns()
{
  const auto turn = [](const double x, const double y, const double z)
  {
    return (Eigen::AngleAxisd(x, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(y, Eigen::Vector3d::UnitY())
            * Eigen::AngleAxisd(z, Eigen::Vector3d::UnitZ())).toRotationMatrix();
  };
  return { turn(0.4, 0, 0.5), turn(0.9, 0.3, -0.7), turn(-0.2, 2.5, 1.2) };
}

template <typename IsSolid>
void check_turned(const IsSolid& is_solid)
{
  for(const Eigen::Matrix3d& turn : turns())
  {
    Turned_body body(is_solid, in_place, turn);
    REQUIRE(body.parameterize(PM::Polycube_axes::FOUND) == VMP::OK);
    Eigen::AlignedBox3d box;
    for(std::size_t v = 0; v < body.soup.points.size(); ++v)
      box.extend(body.point(v));
    double largest = 0;
    for(const std::size_t v : VMP::boundary_vertices(body.soup.points, body.soup.cells))
      largest = (std::max)(largest,
                           (box.center() + body.told() * (body.point(v) - box.center()) - body.image_of(v)).norm());
    CHECK(largest < 1e-5); // the polycube is the body itself, turned as is told
    const Eigen::Matrix3d symmetry = body.told() * turn;
    CHECK((symmetry - symmetry.array().round().matrix()).norm() < 1e-5);
    if(body.parameterize(PM::Polycube_axes::GIVEN) == VMP::OK)
      CHECK(body.told() == Eigen::Matrix3d::Identity());
  }
}

TEST_CASE("a turned polycube is mapped to itself, and by which rotation is told")
{
  check_turned(is_box);
  check_turned(is_bracket);
  check_turned(is_ring);
}

TEST_CASE("a bent body has about the same polycube in each position")
{
  Turned_body as_drawn(is_ring, bend, Eigen::Matrix3d::Identity());
  REQUIRE(as_drawn.parameterize(PM::Polycube_axes::FOUND) == VMP::OK);
  for(const Eigen::Matrix3d& turn : turns())
  {
    Turned_body body(is_ring, bend, turn);
    REQUIRE(body.parameterize(PM::Polycube_axes::FOUND) == VMP::OK);
    CHECK(body.distortion() == Approx(as_drawn.distortion()).epsilon(0.05));
  }
}

TEST_CASE("a body has the same faces as multiples of a spacing in each position and at each place")
{
  const double spacing = 1.3; // no length of the body is a multiple
  Turned_body as_drawn(is_bracket, in_place, Eigen::Matrix3d::Identity());
  REQUIRE(as_drawn.parameterize(PM::Polycube_axes::FOUND, spacing) == VMP::OK);
  for(const Eigen::Matrix3d& turn : turns())
  {
    Turned_body turned(is_bracket, in_place, turn);
    REQUIRE(turned.parameterize(PM::Polycube_axes::FOUND, spacing) == VMP::OK);
    CHECK(turned.distortion() == Approx(as_drawn.distortion()).epsilon(1e-3));
    Turned_body moved(is_bracket, [&](const double x, const double y, const double z)
                      { return in_place(x + turn(0, 1), y + turn(1, 2), z + turn(2, 0)); }, Eigen::Matrix3d::Identity());
    REQUIRE(moved.parameterize(PM::Polycube_axes::FOUND, spacing) == VMP::OK);
    CHECK(moved.distortion() == Approx(as_drawn.distortion()).epsilon(1e-9));
  }
}

TEST_CASE("lengths are rounded to multiples of the spacing, not the places of faces")
{
  const auto between = [](const double x, const double y, const double z) // from 0.3 to 3.7 along x
  { return std::array<double, 3>{ 0.3 + 3.4 / 6 * x, y, z }; };
  const auto width = [](const Turned_body& body)
  {
    const auto [low, high] = std::minmax_element(body.image.begin(), body.image.end());
    return (*high)[0] - (*low)[0];
  };
  Turned_body body(is_box, between, Eigen::Matrix3d::Identity());
  for(const PM::Polycube_axes axes : { PM::Polycube_axes::GIVEN, PM::Polycube_axes::FOUND })
  {
    REQUIRE(body.parameterize(axes, 1) == VMP::OK);
    CHECK(width(body) == 3);
  }
}

TEST_CASE("the order of vertices and cells does not decide about a polycube")
{
  const auto uneven = [](const double x, const double y, const double z) // so that no two vertices are equally far from the center
  { return bend(x + 0.1 * std::sin(7 * y + 3 * z), y + 0.1 * std::sin(5 * z + 2 * x), z + 0.1 * std::sin(4 * x + 6 * y)); };
  Turned_body body(is_stair, uneven, Eigen::Matrix3d::Identity());
  REQUIRE(body.parameterize(PM::Polycube_axes::FOUND, 0.5) == VMP::OK);
  std::mt19937 random(1);
  for(int i = 0; i < 3; ++i)
  {
    Turned_body shuffled = body;
    std::vector<std::size_t> new_index(body.soup.points.size());
    std::iota(new_index.begin(), new_index.end(), 0);
    std::shuffle(new_index.begin(), new_index.end(), random);
    for(std::size_t v = 0; v < new_index.size(); ++v)
      shuffled.soup.points[new_index[v]] = body.soup.points[v];
    for(auto& cell : shuffled.soup.cells)
      for(std::size_t& v : cell)
        v = new_index[v];
    std::shuffle(shuffled.soup.cells.begin(), shuffled.soup.cells.end(), random);
    REQUIRE(shuffled.parameterize(PM::Polycube_axes::FOUND, 0.5) == VMP::OK);
    double largest = 0;
    for(const std::size_t v : VMP::boundary_vertices(body.soup.points, body.soup.cells))
      largest = (std::max)(largest, (shuffled.image_of(new_index[v]) - body.image_of(v)).norm());
    CHECK(largest < 1e-9);
  }
}

TEST_CASE("a body that lies well is not turned, and its polycube is the same, bit by bit")
{
  const auto check = [](const auto& move)
  {
    Turned_body body(is_bracket, move, Eigen::Matrix3d::Identity());
    REQUIRE(body.parameterize(PM::Polycube_axes::GIVEN) == VMP::OK);
    const auto given = body.image;
    REQUIRE(body.parameterize(PM::Polycube_axes::FOUND) == VMP::OK);
    CHECK(body.told() == Eigen::Matrix3d::Identity());
    for(const std::size_t v : VMP::boundary_vertices(body.soup.points, body.soup.cells))
      CHECK(body.image[v] == given[v]);
  };
  check(in_place);
  check([](const double x, const double y, const double z) { return in_place(y, z, x); }); // a symmetry of the cube
  check([](const double x, const double y, const double z) { return in_place(x + 1e-4 * y, y - 1e-4 * x, z); });
}

TEST_CASE("given labels keep the axes")
{
  const Labelled_complex straight(bricks(size, is_bracket, in_place));
  Labelled_complex complex(bricks(size, is_bracket, [](const double x, const double y, const double z)
  { return std::array<double, 3>{ 0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, z }; }));
  copy_labels(straight, complex);
  REQUIRE(complex.parameterize_with_labels() == VMP::OK);
  for(const Facet& f : complex.boundary())
    REQUIRE(direction(complex.image_triangle(f)) == complex.labels.at(f));
}

TEST_CASE("a ball, which has no directions, has a polycube")
{
  const auto ball = [](const double x, const double y, const double z)
  {
    const Eigen::Vector3d p = Eigen::Vector3d(x, y, z).cwiseQuotient(Eigen::Vector3d(6, 5, 7)) * 2 - Eigen::Vector3d::Ones();
    const Eigen::Vector3d q = p.norm() > 0 ? Eigen::Vector3d(p * p.lpNorm<Eigen::Infinity>() / p.norm()) : p;
    return std::array<double, 3>{ q.x(), q.y(), q.z() };
  };
  for(const Eigen::Matrix3d& turn : turns())
  {
    Turned_body body(is_box, ball, turn);
    REQUIRE(body.parameterize(PM::Polycube_axes::FOUND) == VMP::OK);
    CHECK(body.distortion() < 0.5);
  }
}
