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

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_HEXAHEDRA_OF_BODIES_H
