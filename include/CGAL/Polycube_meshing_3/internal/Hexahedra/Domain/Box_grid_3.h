// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BOX_GRID_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BOX_GRID_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedral_mesh_result.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Input_check_3.h>

#include <limits>
#include <map>
#include <set>

namespace CGAL::Polycube_meshing_3::internal {

// Sets the quadrangles of the boundary of boxes, with their hexahedra and faces (from 1). Two quadrangles are of one face if they
// share an edge and their outward normals have the same direction.
inline void set_facets(Hexahedra_3& domain)
{
  std::vector<std::pair<std::array<std::size_t, 3>, std::size_t> > edges; // vertices and direction, quadrangle
  for(const Quadrangle_of_hexahedron& quadrangle : boundary_quadrangles_3(domain))
  {
    const std::array<std::size_t, 4> v = vertices_of(domain, quadrangle);
    const Vector_3& p = domain.points[v[0]];
    const Vector_3 normal = (domain.points[v[1]] - p).cross(domain.points[v[3]] - p);
    const int axis = normal.cwiseAbs().largest_index();
    for(std::size_t i = 0; i < 4; ++i)
    {
      const auto& [first, second] = edge_of_quadrangle(v, i);
      edges.push_back({ { first, second, 2 * static_cast<std::size_t>(axis) + (normal[axis] > 0) }, domain.facets.size() });
    }
    domain.facets.push_back(v);
    domain.facet_cells.push_back(quadrangle.cell);
  }
  Disjoint_sets faces(domain.facets.size());
  for_each_group(edges.size(), [&](const std::size_t i) { return edges[i]; }, [&](const auto begin, const auto end)
  {
    if(end - begin == 2)
      faces.unite(begin->second, (begin + 1)->second);
  });
  for(const std::size_t number : faces.numbers())
    domain.polycube_faces.push_back(1 + number);
}

// Grid of boxes that fits a domain whose boundary facets are orthogonal to the axes. The planes of facets are planes of the grid.
// Therefore, no box is partly inside the domain. Planes through lines in faces are added if there is room. Between two of these
// planes, others are at equal distances near the spacing.
class Box_grid_3
{
public:
  // Takes tetrahedra whose images are the domain, the images of points, and edges of lines in faces. check() says if that fails.
  Box_grid_3(const std::vector<std::array<std::size_t, 4> >& cells, const std::vector<Vector_3>& images,
             const std::vector<std::array<std::size_t, 2> >& lines, const double spacing)
  {
    for(const std::array<std::size_t, 3>& facet : boundary_facets_3(cells))
      if(!add_plane_of(facet, images))
        return;
    for(std::vector<double>& planes : m_planes)
    {
      std::sort(planes.begin(), planes.end());
      planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    }
    add_planes_of_lines(lines, images, spacing);
    if(allows_number_of_boxes(spacing))
      for(std::size_t axis = 0; axis < 3; ++axis)
        divide(axis, spacing);
  }

  const Input_check_3& check() const { return m_check; }

  // Returns the boxes inside, in the order of their centers, without references. `are_inside` takes the centers of all boxes and
  // returns a value for each, true inside, or no values if it has been interrupted. Then there are no boxes.
  template <typename Predicate>
  Hexahedra_3 boxes(const Predicate& are_inside) const
  {
    const auto is_inside = are_inside(centers());
    Hexahedra_3 result;
    constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
    std::vector<std::size_t> vertices(m_planes[0].size() * m_planes[1].size() * m_planes[2].size(), none); // at points of the grid
    std::map<std::array<std::size_t, 3>, std::size_t> blocks; // numbers, by the first boxes along each axis
    for(std::size_t i = 0; i < is_inside.size(); ++i)
    {
      if(!is_inside[i])
        continue;
      const std::size_t n_y = m_planes[1].size() - 1, n_z = m_planes[2].size() - 1;
      const std::array<std::size_t, 3> box = { i / (n_y * n_z), i / n_z % n_y, i % n_z };
      std::array<std::size_t, 8> cell;
      for(std::size_t k = 0; k < 8; ++k)
      {
        const std::size_t x = box[0] + is_upper(k, 0), y = box[1] + is_upper(k, 1), z = box[2] + is_upper(k, 2);
        std::size_t& v = vertices[(x * (n_y + 1) + y) * (n_z + 1) + z];
        if(v == none)
        {
          v = result.points.size();
          result.points.emplace_back(m_planes[0][x], m_planes[1][y], m_planes[2][z]);
        }
        cell[k] = v;
      }
      result.cells.push_back(cell);
      std::array<std::size_t, 3> block, index;
      for(std::size_t axis = 0; axis < 3; ++axis)
      {
        block[axis] = m_first_of_block[axis][box[axis]];
        index[axis] = box[axis] - block[axis];
      }
      result.cell_blocks.push_back(blocks.emplace(block, blocks.size() + 1).first->second);
      result.cell_indices.push_back(index);
    }
    set_facets(result);
    return result;
  }

private:
  // Returns the centers of all boxes; z changes fastest.
  std::vector<Vector_3> centers() const
  {
    std::vector<Vector_3> result;
    for(std::size_t x = 0; x + 1 < m_planes[0].size(); ++x)
      for(std::size_t y = 0; y + 1 < m_planes[1].size(); ++y)
        for(std::size_t z = 0; z + 1 < m_planes[2].size(); ++z)
          result.emplace_back(middle(0, x), middle(1, y), middle(2, z));
    return result;
  }

  // Adds the plane of a facet. If the facet is not orthogonal to an axis, sets the check and returns false.
  bool add_plane_of(const std::array<std::size_t, 3>& facet, const std::vector<Vector_3>& images)
  {
    const Vector_3 &p = images[facet[0]], &q = images[facet[1]], &r = images[facet[2]];
    for(std::size_t axis = 0; axis < 3; ++axis)
      if(p[axis] == q[axis] && q[axis] == r[axis])
      {
        m_planes[axis].push_back(p[axis]);
        return true;
      }
    m_check = failed_check(ERROR_DOMAIN_NOT_AXIS_PARALLEL, "The facet at ", describe(p), ", ", describe(q), ", ", describe(r),
                           " is not orthogonal to an axis.");
    return false;
  }

  // Adds the planes through edges of lines that leave room for a part of the spacing on both sides.
  void add_planes_of_lines(const std::vector<std::array<std::size_t, 2> >& lines, const std::vector<Vector_3>& images,
                           const double spacing)
  {
    constexpr double smallest_part = 0.2; // a guess; less than lines of polycubes leave
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      std::set<double> planes;
      for(const auto& [v, w] : lines)
        if(images[v][axis] == images[w][axis])
          planes.insert(images[v][axis]);
      for(const double plane : planes)
      {
        const auto next = std::lower_bound(m_planes[axis].begin(), m_planes[axis].end(), plane);
        if(next != m_planes[axis].begin() && next != m_planes[axis].end()
           && (std::min)(*next - plane, plane - *(next - 1)) >= smallest_part * spacing)
        {
          m_planes[axis].insert(next, plane);
          m_planes_of_lines[axis].insert(plane);
        }
      }
    }
  }

  // Returns whether memory has room for all boxes: 4 kB each while hexahedra are improved. Otherwise, sets the check.
  bool allows_number_of_boxes(const double spacing)
  {
    constexpr double maximum_number = maximum_number_of_boxes, gigabytes_of_box = 4e-6;
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    if(number_of_boxes(spacing) <= maximum_number)
      return true;
    if(number_of_boxes(infinity) > maximum_number)
      m_check = failed_check(ERROR_SIZE_OUT_OF_RANGE, "The planes of the faces of the domain make ",
                             number_of_boxes(infinity), " boxes. At most ", maximum_number, " are allowed.");
    else
    {
      double coarser = spacing;
      for(const std::vector<double>& planes : m_planes) // each axis alone has a finest spacing
        coarser = (std::max)(coarser, (planes.back() - planes.front()) / maximum_number);
      while(number_of_boxes(coarser) > maximum_number)
        coarser *= 1.1;
      m_check = failed_check(ERROR_SIZE_OUT_OF_RANGE, "The grid would have ", number_of_boxes(spacing),
                             " boxes and may need ", gigabytes_of_box * number_of_boxes(spacing),
                             " GB of memory. At most ", maximum_number, " are allowed. Use a spacing of ", coarser, " or more.");
    }
    return false;
  }

  // Returns the number of all boxes, inside or not, that the planes of faces and lines have for a spacing.
  double number_of_boxes(const double spacing) const
  {
    double product = 1;
    for(const std::vector<double>& planes : m_planes)
    {
      if(planes.size() < 2)
        return 0;
      double sum = 0;
      for(std::size_t i = 1; i < planes.size(); ++i)
        sum += number_of_parts(planes[i] - planes[i - 1], spacing);
      product *= sum;
    }
    return product;
  }

  static double number_of_parts(const double length, const double spacing)
  { return (std::max)(1., std::round(length / spacing)); }

  // Divides the intervals between planes into parts near the spacing, and finds the first box of each block: planes of lines begin
  // no block. Must be called once, after all planes have been added.
  void divide(const std::size_t axis, const double spacing)
  {
    const std::vector<double> planes = m_planes[axis];
    m_planes[axis].resize(planes.empty() ? 0 : 1);
    std::size_t first_of_block = 0;
    for(std::size_t i = 1; i < planes.size(); ++i)
    {
      const double n = number_of_parts(planes[i] - planes[i - 1], spacing);
      if(m_planes_of_lines[axis].count(planes[i - 1]) == 0)
        first_of_block = m_first_of_block[axis].size();
      for(double k = 1; k <= n; ++k)
      {
        m_planes[axis].push_back(k == n ? planes[i] : planes[i - 1] + (planes[i] - planes[i - 1]) * (k / n));
        m_first_of_block[axis].push_back(first_of_block);
      }
    }
  }

  // Returns the coordinate between a plane and the next one.
  double middle(const std::size_t axis, const std::size_t i) const
  { return m_planes[axis][i] + (m_planes[axis][i + 1] - m_planes[axis][i]) / 2; }

  std::array<std::vector<double>, 3> m_planes; // coordinates of planes, along each axis
  std::array<std::set<double>, 3> m_planes_of_lines; // those of lines alone, which divide no block
  // First box of each box's block, along each axis: the first one between the same two planes of faces.
  std::array<std::vector<std::size_t>, 3> m_first_of_block;
  Input_check_3 m_check;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BOX_GRID_3_H
