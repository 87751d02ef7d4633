// Targets of the boundary of a mesh on a domain with a name.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_BOUNDARY_TARGETS_OF_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_BOUNDARY_TARGETS_OF_H

#include "Mesh_format.h"
#include "Named_choices.h"
#include "Progress_line.h"
#include "targets_of_file.h"

#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Surface_fit_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/repair_tetrahedron_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// Landmarks are vertices with the place where each should be. If there are none, a domain finds its way without.
using Landmarks = std::vector<std::pair<std::size_t, std::array<double, 3> > >;

// The vertices for the corners of a box, each in the octant of the corner.
inline std::array<std::size_t, 8> corners_of_box(const Landmarks& landmarks)
{
  std::array<std::size_t, 8> corners = {};
  std::set<int> octants;
  for(const auto& [v, p] : landmarks)
  {
    const int octant = (p[0] > 0) + 2 * (p[1] > 0) + 4 * (p[2] > 0);
    octants.insert(octant);
    corners[octant] = v;
  }
  if(landmarks.size() != 8 || octants.size() != 8)
    throw std::runtime_error("a box needs eight vertices as landmarks, one in each octant");
  return corners;
}

// Ball or box with its landmarks; a model of `BoundaryParameterizer_3`.
struct Ball_or_box
{
  using Ball = VMP::Ball_boundary_parameterizer_3;
  using Box = VMP::Cube_boundary_parameterizer_3;

  std::variant<Ball, Box> domain;
  Landmarks landmarks = {};

  template <typename Cells, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  VMP::Error_code
  parameterize(const Points& points, const Cells& cells, Points& targets, const NamedParameters& np = NamedParameters()) const
  {
    if(landmarks.empty())
      return std::visit([&](const auto& parameterizer) { return parameterizer.parameterize(points, cells, targets, np); }, domain);
    if(const Box* const box = std::get_if<Box>(&domain))
      return box->parameterize(points, cells, corners_of_box(landmarks), targets, np);
    return std::get<Ball>(domain).parameterize(points, cells, landmarks, targets, np);
  }
};

using Polycube = PM::Polycube_boundary_parameterizer_3;
using Surface_fit = VMP::Surface_fit_boundary_parameterizer_3;
using Boundary_parameterizer = std::variant<Ball_or_box, Ball_or_box::Box, Polycube, Surface_fit>;

inline bool is_surface_domain(const std::string& domain) { return format_of(domain) == Mesh_format::SURFACE; }

// `points` are those of the mesh, whose vertices are landmarks.
inline Surface_fit surface_fit(const VMP::Tetrahedron_soup_3& surface, const Landmarks& landmarks, const Points& points,
                               const double tolerance)
{
  std::vector<std::pair<std::array<double, 3>, std::array<double, 3> > > pairs;
  for(const auto& [v, p] : landmarks)
    pairs.emplace_back(points[v], p);
  return Surface_fit(surface.points, surface.facets, pairs, tolerance);
}

// The lengths of the sides of a box from text such as 1,2,0.5
inline Ball_or_box named_box(const std::string& lengths)
{
  double x, y, z;
  char comma[2], rest;
  std::istringstream is(lengths);
  if(!(is >> x >> comma[0] >> y >> comma[1] >> z) || is >> rest || comma[0] != ',' || comma[1] != ','
     || !(std::fmin(x, std::fmin(y, z)) > 0) || std::isinf(x * y * z))
    throw std::runtime_error("'box=" + lengths + "' is not a box with three positive lengths, such as box=1,2,0.5");
  return { Ball_or_box::Box(x, y, z) };
}

inline Boundary_parameterizer named_boundary_parameterizer(const std::string& name, const Polycube& polycube,
                                                           const Landmarks& landmarks = {})
{
  const std::string box = "box=";
  Boundary_parameterizer result = name.compare(0, box.size(), box) == 0
    ? named_box(name.substr(box.size()))
    : find_name<Boundary_parameterizer>("domain", name, {
        {"ball", Ball_or_box{ Ball_or_box::Ball() }}, {"cube", Ball_or_box{ Ball_or_box::Box() }},
        {"box=X,Y,Z", Ball_or_box()}, {"polycube", polycube},
        {"a surface *.off, *.stl, *.obj, *.ply or *.vtp", Ball_or_box()}});
  Ball_or_box* const ball_or_box = std::get_if<Ball_or_box>(&result);
  if(ball_or_box == nullptr)
    return result;
  if(const Ball_or_box::Box* const box = std::get_if<Ball_or_box::Box>(&ball_or_box->domain); box && landmarks.empty())
    return *box; // whose edges on the boundary may be split
  ball_or_box->landmarks = landmarks;
  return result;
}

// None if the name of the file is empty.
inline Landmarks landmarks_of_file(const std::string& filename, const VMP::Tetrahedron_soup_3& mesh, Progress_line& progress)
{
  Landmarks landmarks;
  if(filename.empty())
    return landmarks;
  std::vector<std::string> notes;
  const Points points = targets_of_file(filename, mesh, progress, notes);
  for(std::size_t v = 0; v < points.size(); ++v)
    if(!std::isnan(points[v][0]))
      landmarks.emplace_back(v, points[v]);
  return landmarks;
}

// Returns the place where the boundary is no manifold, and the remedy: copies of vertices, unless facets join all cells around
// each vertex.
inline std::string message_of_non_manifold(VMP::Tetrahedron_soup_3 mesh)
{
  const std::vector<std::size_t> vertices = VMP::non_manifold_boundary_vertices(mesh.points, mesh.cells);
  if(vertices.empty())
    return VMP::get_error_message(VMP::ERROR_NON_MANIFOLD_BOUNDARY);
  const std::string first = std::to_string(vertices.front());
  const std::string sentence = "The boundary is not a manifold at "
    + counted(vertices.size(), "vertex, number ", "vertices, among them number ") + first + " (counted from 0).";
  if(!VMP::separate_pinched_vertices(mesh).empty() || !VMP::split_pinched_edges(mesh).empty())
    return VMP::get_error_message(VMP::ERROR_NON_MANIFOLD_BOUNDARY) + (" " + sentence)
      + " If only vertices or edges join cells there, --separate separates them.";
  return sentence + " Gaps between cells touch each other there. Facets join all cells around each of these vertices, and "
    "--separate has no effect. Close a gap by cells at vertex " + first + ", or remove the cells between the gaps. In a labeled "
    "image, change the label of a voxel there.";
}

// Says why the boundary has no map onto a domain.
inline std::string message_of_domain(const std::string& domain, const VMP::Error_code status, const std::string& message,
                                     const VMP::Tetrahedron_soup_3& mesh)
{
  return "the boundary cannot be mapped to '" + domain + "': "
    + (status == VMP::ERROR_NON_MANIFOLD_BOUNDARY ? message_of_non_manifold(mesh) : message)
    + (status == VMP::ERROR_BOUNDARY_NOT_OF_GENUS_ZERO && domain != "polycube"
       ? " --to polycube maps bodies with handles." : "");
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_BOUNDARY_TARGETS_OF_H
