// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_SURFACE_BOUNDARY_PARAMETERIZER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_SURFACE_BOUNDARY_PARAMETERIZER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_parameterizer_base_3.h>

#include <map>
#include <set>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationBoundary

maps the boundary of a complex onto a triangulated surface with the same connectivity.

Two surfaces are given, for instance read from files. The first one is the boundary of the complex, as
`CGAL::facets_in_complex_3_to_triangle_mesh()` writes it. The second one is the target, whose i-th vertex is the image of the
i-th vertex of the first surface. The vertices of the complex are found by their coordinates, which must be exactly the same.

The function does not check whether the target intersects itself or is turned inside out:
`CGAL::Polygon_mesh_processing::does_self_intersect()` finds self-intersections.

\tparam TriangleMesh a model of `FaceListGraph` with an internal property map for `CGAL::vertex_point_t`

`parameterize()` returns `OK`. Otherwise, it writes nothing and returns one of these codes: `ERROR_EMPTY_COMPLEX`,
`ERROR_NON_FINITE_COORDINATE`, `ERROR_NON_MANIFOLD_BOUNDARY` or `ERROR_INTERRUPTED`. If a facet of the boundary is not a face of
the surfaces, it returns `ERROR_OTHER_CONNECTIVITY`. The running time is in \f$ O(n \log n) \f$ for \f$ n \f$ vertices of the
surfaces.

\cgalModels{BoundaryParameterizer_3}

\sa `Polycube_boundary_parameterizer_3`
*/
template <typename TriangleMesh>
class Surface_boundary_parameterizer_3
  : public internal::Boundary_parameterizer_base_3<Surface_boundary_parameterizer_3<TriangleMesh> >
{
  friend internal::Boundary_parameterizer_base_3<Surface_boundary_parameterizer_3<TriangleMesh> >;

public:
  /// stores references to both surfaces, which must outlive this object.
  Surface_boundary_parameterizer_3(const TriangleMesh& boundary, const TriangleMesh& target)
    : m_boundary(boundary), m_target(target)
  {}

private:
  using Coordinates = std::array<double, 3>;
  using Face = std::array<std::size_t, 3>; // the smallest index comes first
  struct Given {};

  Error_code map(const internal::Numbered_surface_3& surface, Given, std::vector<internal::Vector_3>& images,
                 const internal::Budget& budget) const
  {
    internal::Boundary_mesh_3 mesh;
    const Error_code status = internal::build_boundary_mesh_3(surface, mesh);
    return status == OK ? find_images(surface, images, budget) : status;
  }

  Error_code find_images(const internal::Numbered_surface_3& boundary, std::vector<internal::Vector_3>& images,
                         const internal::Budget& budget) const
  {
    const std::set<Face> surface = faces_of(m_boundary, budget);
    if(faces_of(m_target, budget) != surface)
      return ERROR_OTHER_CONNECTIVITY;

    std::map<Coordinates, std::size_t> index;
    for(const Coordinates& point : points_of(m_boundary))
      index.emplace(point, index.size());
    std::vector<std::size_t> vertex_of_surface;
    for(const internal::Vector_3& point : boundary.points)
    {
      const auto found = index.find(internal::coordinates(point));
      if(found == index.end() || budget.is_exhausted())
        return ERROR_OTHER_CONNECTIVITY;
      vertex_of_surface.push_back(found->second);
    }
    for(const Face& facet : boundary.facets)
      if(surface.count(rotated({ vertex_of_surface[facet[0]], vertex_of_surface[facet[1]],
                                 vertex_of_surface[facet[2]] })) == 0)
        return ERROR_OTHER_CONNECTIVITY;

    const std::vector<Coordinates> points_of_target = points_of(m_target);
    for(const std::size_t v : vertex_of_surface)
      images.push_back(internal::to_vector(points_of_target[v]));
    return OK;
  }

  static Face rotated(Face face)
  {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
  }

  template <typename Mesh>
  static std::set<Face> faces_of(const Mesh& mesh, const internal::Budget& budget)
  {
    std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::size_t> index;
    for(const auto v : vertices(mesh))
      index.emplace(v, index.size());
    std::set<Face> result;
    for(const auto f : faces(mesh))
    {
      if(budget.is_exhausted())
        break;
      const auto h = halfedge(f, mesh);
      result.insert(rotated({ index[source(h, mesh)], index[target(h, mesh)], index[target(next(h, mesh), mesh)] }));
    }
    return result;
  }

  template <typename Mesh>
  static std::vector<Coordinates> points_of(const Mesh& mesh)
  {
    const auto point_map = get(CGAL::vertex_point, mesh);
    std::vector<Coordinates> result;
    for(const auto v : vertices(mesh))
    {
      const auto p = get(point_map, v);
      result.push_back({ CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()) });
    }
    return result;
  }

  const TriangleMesh& m_boundary;
  const TriangleMesh& m_target;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_SURFACE_BOUNDARY_PARAMETERIZER_3_H
