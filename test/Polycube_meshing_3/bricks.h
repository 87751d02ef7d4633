// Bodies of unit bricks, the labels of their facets, and the faces of their polycubes.
#ifndef CGAL_POLYCUBE_MESHING_3_TEST_BRICKS_H
#define CGAL_POLYCUBE_MESHING_3_TEST_BRICKS_H

#include "catch.h"

#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Vector_3 = K::Vector_3;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;
using Cell_handle = C3t3::Cell_handle;
using Facet = C3t3::Facet;
using Brick = std::array<int, 3>;
using Polycube = PM::Polycube_boundary_parameterizer_3;

// The unit bricks in a box for which `is_solid` is true, of six cells each, moved by `move`.
template <typename IsSolid, typename Move>
VMP::Tetrahedron_soup_3 bricks(const Brick& size, const IsSolid& is_solid, const Move& move)
{
  VMP::Tetrahedron_soup_3 soup;
  std::map<Brick, std::size_t> index;
  for(int z = 0; z < size[2]; ++z)
    for(int y = 0; y < size[1]; ++y)
      for(int x = 0; x < size[0]; ++x)
        for(int k = 0; k < 6 && is_solid(x, y, z); ++k)
        {
          Brick p = {x, y, z};
          std::array<std::size_t, 4> cell;
          for(int i = 0; i < 4; ++i)
          {
            const auto inserted = index.emplace(p, soup.points.size());
            if(inserted.second)
              soup.points.push_back(move(p[0], p[1], p[2]));
            cell[i] = inserted.first->second;
            ++p[(k + i * (k < 3 ? 1 : 2)) % 3];
          }
          if(k >= 3)
            std::swap(cell[1], cell[2]);
          soup.cells.push_back(cell);
          soup.cell_references.push_back(1);
        }
  return soup;
}

inline std::array<double, 3> in_place(const double x, const double y, const double z)
{
  return {x, y, z};
}

inline std::array<double, 3> bend(const double x, const double y, const double z)
{
  const double angle = 0.08 * z;
  return {x + 0.3 * std::sin(y), std::cos(angle) * y - std::sin(angle) * (z + 6),
          std::sin(angle) * y + std::cos(angle) * (z + 6)};
}

const Brick size = {6, 5, 7};

inline bool is_box(int, int, int) { return true; }
inline bool is_bracket(const int x, int, const int z) { return x < 2 || z < 3; }
inline bool is_ring(const int x, int, const int z) { return x < 2 || x > 3 || z < 2 || z > 4; }
inline bool is_stair(const int x, const int y, const int z) { return z < 2 || (z < 4 && x < 4 && y < 3) || (x < 2 && y < 3); }

struct Labelled_complex
{
  C3t3 c3t3;
  std::vector<Vertex_handle> vertices;
  std::vector<Cell_handle> cells;
  std::unordered_map<Vertex_handle, Point_3> image;
  std::map<Facet, std::size_t> labels;

  explicit Labelled_complex(const VMP::Tetrahedron_soup_3& soup)
  {
    VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
  }

  Labelled_complex(const Labelled_complex&) = delete;

  VMP::Error_code parameterize(const double spacing = 0)
  {
    image.clear();
    return Polycube(spacing).parameterize(c3t3, boost::make_assoc_property_map(image));
  }

  VMP::Error_code parameterize_with_labels(const double spacing = 0)
  {
    image.clear();
    return Polycube(spacing).parameterize(c3t3, boost::make_assoc_property_map(labels),
                                          boost::make_assoc_property_map(image));
  }

  std::vector<Facet> boundary() const
  {
    std::vector<Facet> result;
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(!c3t3.is_in_complex(c->neighbor(i)))
          result.emplace_back(c, i);
    return result;
  }

  // Counterclockwise as seen from outside.
  static std::array<Vertex_handle, 3> vertices_of(const Facet& f)
  {
    std::array<Vertex_handle, 3> result;
    for(int k = 0; k < 3; ++k)
      result[k] = f.first->vertex((f.second + 1 + k) % 4);
    if(f.second % 2 == 1)
      std::swap(result[0], result[1]);
    return result;
  }

  template <typename Point>
  static std::array<Point_3, 3> triangle(const Facet& f, const Point& point)
  {
    const std::array<Vertex_handle, 3> v = vertices_of(f);
    return { point(v[0]), point(v[1]), point(v[2]) };
  }

  std::array<Point_3, 3> source_triangle(const Facet& f) const
  {
    return triangle(f, [](const Vertex_handle v) { return v->point(); });
  }

  std::array<Point_3, 3> image_triangle(const Facet& f) const
  {
    return triangle(f, [this](const Vertex_handle v) { return image.at(v); });
  }
};

// The direction to which a triangle normal to an axis turns its front, by exact predicates; 6 if it is not normal
// to an axis or flat.
inline std::size_t direction(const std::array<Point_3, 3>& t)
{
  for(int axis = 0; axis < 3; ++axis)
    if(t[0][axis] == t[1][axis] && t[0][axis] == t[2][axis])
    {
      std::array<double, 3> above = { t[0].x(), t[0].y(), t[0].z() };
      above[axis] = std::nextafter(above[axis], (std::numeric_limits<double>::infinity)());
      switch(CGAL::orientation(t[0], t[1], t[2], Point_3(above[0], above[1], above[2])))
      {
        case CGAL::POSITIVE: return 2 * axis;
        case CGAL::NEGATIVE: return 2 * axis + 1;
        default: return 6;
      }
    }
  return 6;
}

// Labels a complex like one with the same cells whose facets are normal to the axes.
inline void copy_labels(const Labelled_complex& straight, Labelled_complex& complex)
{
  const std::vector<Facet> from = straight.boundary(), to = complex.boundary();
  for(std::size_t i = 0; i < from.size(); ++i)
    complex.labels[to[i]] = direction(straight.source_triangle(from[i]));
}

// Returns the faces by direction and coordinate. Each triangle of the image is normal to an axis.
inline std::set<std::pair<std::size_t, double> > faces_of_image(const Labelled_complex& complex)
{
  std::set<std::pair<std::size_t, double> > faces;
  for(const Facet& f : complex.boundary())
  {
    const std::array<Point_3, 3> t = complex.image_triangle(f);
    REQUIRE(direction(t) < 6);
    faces.emplace(direction(t), t[0][static_cast<int>(direction(t) / 2)]);
  }
  return faces;
}

// The boundary of a soup, with points of its own.
struct Soup_surface
{
  std::vector<PM::internal::Vector_3> points;
  std::vector<std::array<std::size_t, 3> > facets;

  explicit Soup_surface(const VMP::Tetrahedron_soup_3& soup)
  {
    std::map<std::size_t, std::size_t> number;
    for(std::array<std::size_t, 3> facet : VMP::internal::boundary_facets_3(soup.cells))
    {
      for(std::size_t& v : facet)
      {
        const auto inserted = number.emplace(v, points.size());
        if(inserted.second)
          points.emplace_back(soup.points[v][0], soup.points[v][1], soup.points[v][2]);
        v = inserted.first->second;
      }
      facets.push_back(facet);
    }
  }

  PM::internal::Vector_3 center(const std::size_t facet) const
  {
    const auto& [a, b, c] = facets[facet];
    return (points[a] + points[b] + points[c]) / 3;
  }
};

#endif // CGAL_POLYCUBE_MESHING_3_TEST_BRICKS_H
