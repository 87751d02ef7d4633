// Boundaries mapped to given surfaces with the same connectivity.
#include "Visitor_that_ends.h"
#include "bricks.h"

#include <CGAL/Volume_mesh_parameterization/Surface_boundary_parameterizer_3.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/property_map.hpp>

#include <map>
#include <vector>

namespace {

using Surface = CGAL::Surface_mesh<Point_3>;

Surface boundary_surface(const Labelled_complex& complex)
{
  Surface result;
  std::map<Vertex_handle, Surface::Vertex_index> index;
  for(const Facet& f : complex.boundary())
    for(const Vertex_handle v : Labelled_complex::vertices_of(f))
      if(index.count(v) == 0)
        index[v] = result.add_vertex(v->point());
  for(const Facet& f : complex.boundary())
  {
    const std::array<Vertex_handle, 3> v = Labelled_complex::vertices_of(f);
    result.add_face(index[v[1]], index[v[2]], index[v[0]]);
  }
  return result;
}

} // namespace

TEST_CASE("the boundary is mapped to a surface with the same connectivity")
{
  Labelled_complex complex(bricks(size, is_ring, bend));
  Surface boundary = boundary_surface(complex), target = boundary;
  for(const auto v : target.vertices())
    target.point(v) = Point_3(boundary.point(v).z(), boundary.point(v).x(), 2 * boundary.point(v).y());
  const auto parameterize = [&]()
  {
    complex.image.clear();
    return VMP::Surface_boundary_parameterizer_3<Surface>(boundary, target)
      .parameterize(complex.c3t3, boost::make_assoc_property_map(complex.image));
  };
  REQUIRE(parameterize() == VMP::OK);
  CHECK(complex.image.size() == boundary.number_of_vertices());
  for(const auto& entry : complex.image)
  {
    const Point_3 p = entry.first->point();
    CHECK(entry.second == Point_3(p.z(), p.x(), 2 * p.y()));
  }

  CGAL::Euler::flip_edge(*target.halfedges().begin(), target);
  CHECK(parameterize() == VMP::ERROR_OTHER_CONNECTIVITY);
  CGAL::Euler::flip_edge(*boundary.halfedges().begin(), boundary);
  CHECK(parameterize() == VMP::ERROR_OTHER_CONNECTIVITY);
  CHECK(complex.image.empty());
  boundary = target = boundary_surface(complex);
  CHECK(parameterize() == VMP::OK);
  boundary.point(*boundary.vertices().begin()) = Point_3(-1, -1, -1);
  CHECK(parameterize() == VMP::ERROR_OTHER_CONNECTIVITY);
}

TEST_CASE("maps to given surfaces can be ended anywhere, with nothing written")
{
  Labelled_complex complex(bricks(size, is_ring, bend));
  const Surface boundary = boundary_surface(complex);
  const VMP::Surface_boundary_parameterizer_3<Surface> parameterizer(boundary, boundary);
  check_interruption([&](const auto& np)
  {
    return parameterizer.parameterize(complex.c3t3, boost::make_assoc_property_map(complex.image), np);
  }, complex.image);
}
