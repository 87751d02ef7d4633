// Carries a scalar field and the points of a solid texture from an elephant to a bull, through the unit ball.
#include "mesh_elephant.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

using Vertex_handle = C3t3::Vertex_handle;
using Points = std::vector<std::array<double, 3> >;

namespace VMP = CGAL::Volume_mesh_parameterization;

Vertex_handle nearest_boundary_vertex(const C3t3& c3t3, const Point_3& p)
{
  const std::vector<Vertex_handle> vertices = VMP::boundary_vertices(c3t3);
  return *std::min_element(vertices.begin(), vertices.end(), [&](const Vertex_handle v, const Vertex_handle w)
  { return CGAL::has_smaller_distance_to_point(p, v->point().point(), w->point().point()); });
}

// A body with its map to the ball.
struct Body
{
  VMP::Tetrahedron_soup_3 mesh;
  Points in_ball; // the images of the vertices

  // The ball is turned such that the vertices nearest to the landmarks come close to these points.
  Body(const std::string& filename, const std::vector<Point_3>& landmarks, const std::vector<Point_3>& points)
  {
    C3t3 c3t3 = mesh_elephant(CGAL::data_file_path(filename));
    std::vector<std::pair<Vertex_handle, Point_3> > landmark_vertices;
    for(std::size_t i = 0; i < points.size(); ++i)
      landmark_vertices.emplace_back(nearest_boundary_vertex(c3t3, landmarks[i]), points[i]);
    std::unordered_map<Vertex_handle, Point_3> target, uvw;
    const auto target_map = VMP::make_vertex_point_map(target);
    const VMP::Error_code status = VMP::Ball_boundary_parameterizer_3().parameterize(c3t3, landmark_vertices, target_map);
    if(status != VMP::OK)
      throw std::runtime_error(VMP::get_error_message(status));
    const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
      c3t3, VMP::make_vertex_point_map(uvw), CGAL::parameters::boundary_map(target_map)
                                                  .refinement_mode(VMP::Refinement_mode::HELPFUL));
    std::cout << filename << ": " << result.number_of_cells << " cells. " << result.message << std::endl;
    if(!result.has_valid_map || result.boundary_residual > 0)
      throw std::runtime_error("The body has no map to the ball.");

    std::vector<Vertex_handle> vertices;
    VMP::mesh_complex_3_to_tetrahedron_soup(c3t3, mesh, vertices);
    for(const Vertex_handle v : vertices)
      in_ball.push_back({ uvw.at(v).x(), uvw.at(v).y(), uvw.at(v).z() });
  }

  VMP::Volume_map_3 map() const { return VMP::Volume_map_3(mesh.points, mesh.cells, in_ball); }
};

// Writes the mesh with the points from which it has its texture, and with a field; the vertices nearest to the landmarks are
// marked by 1, 2, ..., the others by 0.
bool write(const std::string& filename, VMP::Tetrahedron_soup_3 mesh, const Points& texture, const std::vector<double>& field,
           const std::vector<Point_3>& landmarks)
{
  std::vector<double> marks(mesh.points.size());
  for(std::size_t i = 0; i < landmarks.size(); ++i)
  {
    const auto distance = [&](const std::array<double, 3>& p)
    { return CGAL::squared_distance(landmarks[i], Point_3(p[0], p[1], p[2])); };
    const auto nearest = std::min_element(mesh.points.begin(), mesh.points.end(), [&](const auto& p, const auto& q)
    { return distance(p) < distance(q); });
    marks[static_cast<std::size_t>(nearest - mesh.points.begin())] = static_cast<double>(i + 1);
  }
  mesh.point_data = { { "field", 1, false, field }, { "landmark", 1, true, marks } };
  return VMP::IO::write_VTU(filename, mesh, texture);
}

int main()
try
{
  // Nose, front feet and hind feet, the left ones first, need not be exactly on the surfaces.
  const std::vector<Point_3> of_elephant = { {0.18, 0.5, 0.09}, {0.35, -0.3, -0.28}, {0.1, -0.48, -0.03},
                                             {-0.36, -0.42, -0.21}, {-0.15, -0.5, -0.04} };
  const std::vector<Point_3> of_bull = { {-0.4, 0.05, 0.35}, {-0.46, -0.32, -0.09}, {-0.31, -0.28, -0.39},
                                         {0.38, -0.31, 0.13}, {0.25, -0.27, -0.24} };
  const Body elephant("meshes/elephant.off", of_elephant, {});
  const VMP::Volume_map_3 elephant_to_ball = elephant.map();
  std::vector<Point_3> in_ball;
  for(const Point_3& p : of_elephant)
    in_ball.push_back(elephant_to_ball.nearest_image(p)->point);
  const Body bull("meshes/bull.off", of_bull, in_ball);
  const VMP::Volume_map_3 bull_to_ball = bull.map();
  for(std::size_t i = 0; i < in_ball.size(); ++i)
    std::cout << "landmark " << i << ": distance in the ball "
              << std::sqrt(CGAL::squared_distance(bull_to_ball.nearest_image(of_bull[i])->point, in_ball[i])) << std::endl;

  // The field: the distance from the tip of the trunk.
  std::vector<double> field, carried_field;
  for(const std::array<double, 3>& p : elephant.mesh.points)
    field.push_back(std::sqrt(CGAL::squared_distance(Point_3(p[0], p[1], p[2]), of_elephant[0])));

  // Each vertex of the bull takes it from where it comes to be in the elephant.
  Points carried;
  for(const std::array<double, 3>& q : bull.in_ball)
  {
    const auto preimage = *elephant_to_ball.nearest_preimage(Point_3(q[0], q[1], q[2]));
    carried.push_back({ preimage.point.x(), preimage.point.y(), preimage.point.z() });
    carried_field.push_back(elephant_to_ball.interpolate(preimage, field));
  }
  const bool is_written = write("elephant.vtu", elephant.mesh, elephant.mesh.points, field, of_elephant)
                          && write("bull.vtu", bull.mesh, carried, carried_field, of_bull);
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
catch(const std::exception& error)
{
  std::cerr << error.what() << std::endl;
  return EXIT_FAILURE;
}
