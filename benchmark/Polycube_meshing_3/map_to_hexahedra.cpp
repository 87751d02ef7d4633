// Maps a tetrahedral mesh to a cube or a polycube, pulls a grid back, and prints what the hexahedra are like.
#include <CGAL/Polycube_meshing_3/IO/write_hexahedron_soup.h>
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Point_map = std::unordered_map<C3t3::Vertex_handle, Point_3>;
using Triangles = std::vector<std::array<std::size_t, 3> >;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;
namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

std::vector<Point_3> points_of(const std::vector<std::array<double, 3> >& coordinates)
{
  std::vector<Point_3> points;
  for(const auto& p : coordinates)
    points.emplace_back(p[0], p[1], p[2]);
  return points;
}

Surface_mesh surface(const std::vector<std::array<double, 3> >& coordinates, const Triangles& triangles)
{
  Surface_mesh result;
  PMP::polygon_soup_to_polygon_mesh(points_of(coordinates), triangles, result);
  PMP::remove_isolated_vertices(result);
  return result;
}

Triangles boundary(const VMP::Tetrahedron_soup_3& mesh)
{
  return VMP::internal::boundary_facets_3(mesh.cells);
}

Triangles boundary(const PM::Hexahedron_soup_3& mesh)
{
  Triangles result;
  for(const auto& [a, b, c, d] : mesh.facets)
  {
    result.push_back({ a, b, c });
    result.push_back({ a, c, d });
  }
  return result;
}

// Returns the part of the sharp edges of the body, by length, whose quarters have their middles within a tenth of the spacing of
// edges of quadrangles; 1 if there are none.
double part_of_sharp_edges(const VMP::Tetrahedron_soup_3& soup, const PM::Hexahedron_soup_3& mesh, const double spacing)
{
  std::vector<K::Segment_3> edges;
  const std::vector<Point_3> ends = points_of(mesh.points), points = points_of(soup.points);
  for(const auto& f : mesh.facets)
    for(std::size_t k = 0; k < 4; ++k)
      edges.emplace_back(ends[f[k]], ends[f[(k + 1) % 4]]);
  using Primitive = CGAL::AABB_segment_primitive<K, std::vector<K::Segment_3>::const_iterator>;
  const CGAL::AABB_tree<CGAL::AABB_traits<K, Primitive> > tree(edges.cbegin(), edges.cend());
  double all = 0, near = 0;
  const auto point = [&](const std::size_t i) { return VMP::internal::to_vector(soup.points[i]); };
  for(const auto& [v, w] : VMP::internal::sharp_edges_3(boundary(soup), soup.edges, point))
    for(const double part : { 0.125, 0.375, 0.625, 0.875 })
    {
      const double length = std::sqrt(CGAL::squared_distance(points[v], points[w])) / 4;
      all += length;
      near += tree.squared_distance(points[v] + part * (points[w] - points[v])) <= spacing * spacing / 100 ? length : 0;
    }
  return all > 0 ? near / all : 1;
}

VMP::Error_code map_boundary(const C3t3& c3t3, const std::string& domain, const double spacing, Point_map& target)
{
  const auto target_map = VMP::make_vertex_point_map(target);
  if(domain == "cube") return VMP::Cube_boundary_parameterizer_3().parameterize(c3t3, target_map);
  if(domain == "polycube") return PM::Polycube_boundary_parameterizer_3(spacing).parameterize(c3t3, target_map);
  throw std::runtime_error("there is no domain '" + domain + "'");
}

void map_to_hexahedra(const std::string& source, const std::string& domain, const double number,
                      const std::string& output)
{
  VMP::Tetrahedron_soup_3 soup;
  VMP::IO::read_MEDIT(source, soup);
  const std::vector<Point_3> points = points_of(soup.points);
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  const double longest = (std::max)({ box.x_span(), box.y_span(), box.z_span() });
  const double spacing = (domain == "cube" ? 1 : longest) / number;

  C3t3 c3t3;
  std::vector<C3t3::Vertex_handle> vertices;
  std::vector<C3t3::Cell_handle> cells;
  VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
  Point_map target, uvw;
  const VMP::Error_code status = map_boundary(c3t3, domain, spacing, target);
  if(status != VMP::OK)
  {
    std::cout << "status: no boundary: " << VMP::get_error_message(status) << std::endl;
    return;
  }
  const VMP::Parameterization_result map
    = CGAL::stretch_minimizing_volume_parameterization<CGAL::Parallel_if_available_tag>(
      c3t3, VMP::make_vertex_point_map(uvw),
      params::boundary_map(VMP::make_vertex_point_map(target)).refinement_mode(VMP::Refinement_mode::HELPFUL));
  if(map.boundary_residual != 0)
  {
    std::cout << "status: no map: " << map.message << std::endl;
    return;
  }

  std::cout << "boundary_distortion: " << map.boundary_distortion << std::endl;
  PM::Hexahedron_soup_3 mesh;
  CGAL::Real_timer timer;
  timer.start();
  const PM::Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3<CGAL::Parallel_if_available_tag>(
    c3t3, VMP::make_vertex_point_map(uvw), spacing, mesh);
  timer.stop();
  std::cout << "status: " << (result.status == VMP::OK ? "OK" : result.message)
            << "\ntetrahedra: " << map.number_of_cells
            << "\nhexahedra: " << result.number_of_cells << "\npadding: " << result.has_padding
            << "\ninverted_hexahedra: " << result.number_of_inverted_hexahedra
            << "\nminimum_scaled_jacobian: " << result.minimum_scaled_jacobian
            << "\nmean_scaled_jacobian: " << result.mean_scaled_jacobian
            << "\nseconds_map: " << map.seconds_total << "\nseconds_hexahedra: " << timer.time() << std::endl;
  if(result.status == VMP::OK)
    std::cout << "sharp_edges: " << part_of_sharp_edges(soup, mesh, longest / number) << std::endl;
  if(result.status == VMP::OK)
    std::cout << "hausdorff_distance: "
              << PMP::approximate_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(
                   surface(soup.points, boundary(soup)), surface(mesh.points, boundary(mesh))) * number / longest << std::endl;
  if(result.status == VMP::OK && !output.empty())
  {
    std::ofstream out(output);
    PM::IO::write_MEDIT(out, mesh);
  }
}

int main(int argc, char* argv[])
{
  const double number = argc > 3 ? std::atof(argv[3]) : 0;
  if(!(number > 0))
  {
    std::cerr << "Usage: map_to_hexahedra SOURCE.mesh DOMAIN NUMBER [OUTPUT.mesh]\n"
                 "DOMAIN is cube or polycube, and NUMBER is that of hexahedra along the longest side of the body, or\n"
                 "of the cube. The Hausdorff distance of the surfaces is in parts of the longest side over NUMBER."
              << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    map_to_hexahedra(argv[1], argv[2], number, argc > 4 ? argv[4] : "");
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
