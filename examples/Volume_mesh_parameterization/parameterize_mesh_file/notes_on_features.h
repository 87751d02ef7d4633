// Notes on the sharp edges of the source of parameterize_mesh_file.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_NOTES_ON_FEATURES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_NOTES_ON_FEATURES_H

#include <CGAL/Volume_mesh_parameterization/Polycube_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

// Tells which edges would be sharp if the mesh marked none, but are not as it marks others; nothing if there are none.
inline std::string note_of_unmarked_edges(const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup)
{
  if(soup.edges.empty())
    return "";
  using CGAL::Volume_mesh_parameterization::sharp_boundary_edges;
  const auto sharp = sharp_boundary_edges(soup.points, soup.cells, soup.edges);
  const auto by_angle = sharp_boundary_edges(soup.points, soup.cells);
  std::vector<std::array<std::size_t, 2> > unmarked;
  std::set_difference(by_angle.begin(), by_angle.end(), sharp.begin(), sharp.end(), std::back_inserter(unmarked));
  return unmarked.empty() ? std::string()
    : std::to_string(unmarked.size()) + " sharp edges of the boundary, as that between the vertices "
      + std::to_string(unmarked[0][0]) + " and " + std::to_string(unmarked[0][1])
      + " (counted from 0), are not among the marked ones, and are not followed; --features FILE tells others";
}

// Tells how many sharp edges a polycube gives up, and where the longest line of them is; nothing if there are none.
inline std::string note_of_features_given_up(const CGAL::Volume_mesh_parameterization::Polycube_result& polycube)
{
  namespace internal = CGAL::Volume_mesh_parameterization::internal;
  if(polycube.features_given_up.empty())
    return "";
  const std::size_t lines = polycube.features_given_up.size();
  const auto& longest = polycube.features_given_up.front();
  const auto& [x, y, z] = longest[longest.size() / 2];
  std::ostringstream result;
  result << polycube.number_of_edges_given_up() << " of " << polycube.number_of_sharp_edges
         << " sharp edges lead along no axis of the polycube, in " << lines << (lines == 1 ? " line" : " lines")
         << ", and hexahedra do not follow them: the longest leads through (" << x << ", " << y << ", " << z << ")";
  return result.str();
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_NOTES_ON_FEATURES_H
