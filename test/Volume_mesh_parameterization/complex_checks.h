// Checks of a complex and of the images of its vertices.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_COMPLEX_CHECKS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_COMPLEX_CHECKS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <array>
#include <cmath>
#include <unordered_set>

template <typename Point_3>
bool has_finite_coordinates(const Point_3& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

template <typename Point_3>
bool has_same_bits(const Point_3& p, const Point_3& q)
{
  for(int i = 0; i < 3; ++i)
    if(p[i] != q[i] || std::signbit(p[i]) != std::signbit(q[i]))
      return false;
  return true;
}

// Returns whether all cells are positive, by exact predicates on the points that `point` returns.
template <typename C3t3, typename Function>
bool has_positive_cells(const C3t3& c3t3, const Function& point)
{
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    std::array<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3, 4> p;
    for(int i = 0; i < 4; ++i)
    {
      p[i] = point(c->vertex(i));
      if(!has_finite_coordinates(p[i]))
        return false;
    }
    if(CGAL::orientation(p[0], p[1], p[2], p[3]) != CGAL::POSITIVE)
      return false;
  }
  return true;
}

template <typename C3t3>
bool has_positive_cells(const C3t3& c3t3)
{
  return has_positive_cells(c3t3, [](const typename C3t3::Vertex_handle v) { return v->point(); });
}

// Returns whether cells know their neighbors, and vertices their cells.
template <typename Tr>
bool is_consistent(const Tr& tr)
{
  for(const typename Tr::Cell_handle c : tr.all_cell_handles())
    for(int i = 0; i < 4; ++i)
    {
      const typename Tr::Cell_handle n = c->neighbor(i);
      if(n->neighbor(n->index(c)) != c || n->has_vertex(c->vertex(i)))
        return false;
      for(int j = 1; j < 4; ++j)
        if(!n->has_vertex(c->vertex((i + j) % 4)))
          return false;
    }
  for(const typename Tr::Vertex_handle v : tr.finite_vertex_handles())
    if(!v->cell()->has_vertex(v))
      return false;
  return true;
}

template <typename C3t3>
std::unordered_set<typename C3t3::Vertex_handle> vertices_of_cells(const C3t3& c3t3)
{
  std::unordered_set<typename C3t3::Vertex_handle> result;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    for(int i = 0; i < 4; ++i)
      result.insert(c->vertex(i));
  return result;
}

template <typename C3t3>
std::unordered_set<typename C3t3::Vertex_handle> boundary_vertices(const C3t3& c3t3)
{
  std::unordered_set<typename C3t3::Vertex_handle> result;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    for(int i = 0; i < 4; ++i)
      for(int j = 1; j < 4 && !c3t3.is_in_complex(c->neighbor(i)); ++j)
        result.insert(c->vertex((i + j) % 4));
  return result;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_COMPLEX_CHECKS_H
