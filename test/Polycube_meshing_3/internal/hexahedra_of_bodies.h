// Bodies of which hexahedra are made, and what is checked of these.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_HEXAHEDRA_OF_BODIES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_HEXAHEDRA_OF_BODIES_H

#include "catch.h"
#include "cube_complex.h"

#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Hexahedra_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Eigen::Vector3d;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using PM::Hexahedral_mesh_result;
using PM::Hexahedron_soup_3;
using PM::internal::Hexahedra_3;
using VMP::Tetrahedron_soup_3;
using Points = std::vector<std::array<double, 3> >;

template <typename Point>
Vector3d vector(const Point& p) { return Vector3d(p[0], p[1], p[2]); }

template <typename PointRange>
K::Triangle_3 triangle(const PointRange& points, const std::size_t i, const std::size_t j, const std::size_t k)
{
  const auto point = [&](const std::size_t v) { return K::Point_3(points[v][0], points[v][1], points[v][2]); };
  return K::Triangle_3(point(i), point(j), point(k));
}

// The cube [0, n]^3, six cells for each unit cube, as the domain; the body is its image under f.
struct Body
{
  Tetrahedron_soup_3 soup;
  Points images;

  template <typename Function>
  Body(const int n, const double jitter, const Function& f)
    : soup(source_soup(cube_mesh(n, jitter))), images(soup.points)
  {
    for(std::array<double, 3>& p : soup.points)
    {
      const Vector3d q = f(vector(p));
      p = { q[0], q[1], q[2] };
    }
  }

  Vector3d center_of_image(const std::array<std::size_t, 4>& cell) const
  {
    return (vector(images[cell[0]]) + vector(images[cell[1]]) + vector(images[cell[2]]) + vector(images[cell[3]])) / 4;
  }

  template <typename Tag = CGAL::Sequential_tag, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Hexahedral_mesh_result mesh(const double spacing, Hexahedron_soup_3& hexahedra,
                              const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    return PM::make_hexahedral_mesh_3<Tag>(soup.points, soup.cells, images, spacing, hexahedra, np);
  }

  std::vector<K::Triangle_3> boundary_facets() const
  {
    std::map<std::set<std::size_t>, int> cells_of_facet;
    for(const auto& c : soup.cells)
      for(std::size_t i = 0; i < 4; ++i)
        ++cells_of_facet[{ c[(i + 1) % 4], c[(i + 2) % 4], c[(i + 3) % 4] }];
    std::vector<K::Triangle_3> result;
    for(const auto& [facet, number] : cells_of_facet)
      if(number == 1)
        result.push_back(triangle(soup.points, *facet.begin(), *std::next(facet.begin()), *facet.rbegin()));
    return result;
  }
};

template <typename Hexahedra>
std::vector<K::Triangle_3> boundary_facets(const Hexahedra& mesh)
{
  std::vector<K::Triangle_3> result;
  for(const auto& f : mesh.facets)
    for(const std::size_t i : { 1, 2 })
      result.push_back(triangle(mesh.points, f[0], f[i], f[i + 1]));
  return result;
}

// The smallest distance, one after the other.
inline double distance(const std::array<double, 3>& p, const std::vector<K::Triangle_3>& facets)
{
  double result = std::numeric_limits<double>::infinity();
  for(const K::Triangle_3& facet : facets)
    result = (std::min)(result, CGAL::squared_distance(K::Point_3(p[0], p[1], p[2]), facet));
  return std::sqrt(result);
}

inline void check_boundary(const Hexahedron_soup_3& mesh, const Body& body)
{
  const std::vector<K::Triangle_3> facets = body.boundary_facets();
  const std::vector<bool> is_outer = PM::internal::is_on_boundary(mesh);
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    if(is_outer[v])
      CHECK(distance(mesh.points[v], facets) < 1e-13);
}

inline Vector3d same(const Vector3d& p) { return p; }

// Computes the volume by the divergence theorem, with two triangles for each quadrangle: independent of the corners.
inline double enclosed_volume(const Hexahedron_soup_3& mesh)
{
  double sum = 0;
  for(const auto& [a, b, c, d] : mesh.facets)
    for(const auto& triangle : { std::array<std::size_t, 3>{a, b, c}, std::array<std::size_t, 3>{a, c, d} })
      sum += vector(mesh.points[triangle[0]]).dot(
        vector(mesh.points[triangle[1]]).cross(vector(mesh.points[triangle[2]]))) / 6;
  return sum;
}

// The determinants of all corners, by the definition of VTK's order.
template <typename Hexahedra>
double smallest_determinant(const Hexahedra& mesh)
{
  double smallest = std::numeric_limits<double>::infinity();
  for(const auto& cell : mesh.cells)
    for(int z = 0; z < 2; ++z)
      for(int i = 0; i < 4; ++i)
      {
        const auto corner = [&](const int k, const int height)
        {
          return vector(mesh.points[cell[4 * height + k % 4]]);
        };
        Eigen::Matrix3d edges;
        edges << corner(i + 1, z) - corner(i, z), corner(i + 3, z) - corner(i, z), corner(i, 1) - corner(i, 0);
        smallest = (std::min)(smallest, edges.determinant());
      }
  return smallest;
}

// Most of a ring, whose inner side is short.
inline Vector3d bent(const Vector3d& p)
{
  const double angle = 1.2 * p[0], radius = 1 + p[1];
  return Vector3d(radius * std::sin(angle), radius * std::cos(angle), p[2]);
}

// The cube [0, 8]^3 to a ball of radius 4: each sphere in the maximum norm becomes one in the Euclidean norm.
inline Vector3d rounded(const Vector3d& p)
{
  const Vector3d q = p - Vector3d::Constant(4);
  return q.isZero() ? q : Vector3d(q * (q.lpNorm<Eigen::Infinity>() / q.norm()));
}

// The cube [0, 4]^3 to a cylinder of radius 2: each square around the axis becomes a circle.
inline Vector3d rounded_around_z(const Vector3d& p)
{
  const Vector3d q(p[0] - 2, p[1] - 2, 0);
  return q.isZero() ? p : Vector3d(q * (q.lpNorm<Eigen::Infinity>() / q.norm()) + Vector3d(2, 2, p[2]));
}

// A disc with a thinner one on it: two cylinders with sharp circles, one of them concave.
inline Body disc_with_stem()
{
  Body body(4, 0, rounded_around_z);
  auto& cells = body.soup.cells;
  cells.erase(std::remove_if(cells.begin(), cells.end(), [&](const std::array<std::size_t, 4>& cell)
              { const Vector3d p = body.center_of_image(cell) - Vector3d::Constant(2);
                return p[2] > 0 && p.head<2>().lpNorm<Eigen::Infinity>() > 1; }), cells.end());
  return body;
}

inline Body l_shaped_bar()
{
  Body bar(4, 0, bent);
  auto& cells = bar.soup.cells;
  cells.erase(std::remove_if(cells.begin(), cells.end(), [&](const std::array<std::size_t, 4>& cell)
              { const Vector3d p = bar.center_of_image(cell); return p[1] > 2 && p[2] > 2; }), cells.end());
  return bar;
}

inline std::vector<int> boundary_quadrangles_of_cells(const Hexahedron_soup_3& mesh)
{
  std::map<std::set<std::size_t>, std::vector<std::size_t> > cells;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    for(const auto& q : PM::internal::quadrangles_of_hexahedron)
      cells[{ mesh.cells[c][q[0]], mesh.cells[c][q[1]], mesh.cells[c][q[2]], mesh.cells[c][q[3]] }].push_back(c);
  std::vector<int> result(mesh.cells.size(), 0);
  for(const auto& entry : cells)
    if(entry.second.size() == 1)
      ++result[entry.second[0]];
  return result;
}

// A box whose faces the map has turned inside.
inline Body turned_box()
{
  Body box(6, 0, same);
  for(std::array<double, 3>& q : box.images)
  {
    const double x = q[0] - 3, y = q[1] - 3, part = (1 - x * x / 9) * (1 - y * y / 9); // 0 on the sides
    const double angle = 1.3 * part;
    q[0] = 3 + std::cos(angle) * x - std::sin(angle) * y;
    q[1] = 3 + std::sin(angle) * x + std::cos(angle) * y;
  }
  return box;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_HEXAHEDRA_OF_BODIES_H
