// The sharp edges of the source of parameterize_mesh_file, and the option --features, a list of them.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_FEATURES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_FEATURES_H

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Polycube_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Text.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

// Reads lines of two vertices, counted from 0. The first line may be their number.
inline std::vector<std::array<std::size_t, 2> > features_of_file(const std::string& filename, const std::size_t number_of_points)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  const VMP::internal::Budget budget;
  const std::string text = VMP::internal::read_file(filename, budget);
  VMP::internal::Text_scanner scanner(text, budget);
  std::vector<std::array<std::size_t, 2> > result;
  for(bool is_first = true; !scanner.rest().empty(); is_first = false)
  {
    VMP::internal::Text_scanner line = scanner.next_line();
    if(line.rest().find(',') != std::string_view::npos)
      line.fail("a line must contain two vertices of the mesh; "
                "sides of triangles, as in files .sharp of LoopyCuts, are not supported");
    const std::size_t v = line.next_number<std::size_t>("the index of a vertex");
    if(is_first && line.rest().empty())
      continue;
    const std::size_t w = line.next_number<std::size_t>("the index of a vertex");
    line.expect_end("the two vertices of an edge");
    if(v >= number_of_points || w >= number_of_points || v == w)
      line.fail("there is no edge between the vertices " + std::to_string(v) + " and " + std::to_string(w) + " (counted from 0)");
    result.push_back({ v, w });
  }
  return result;
}

// Marks the edges of a list in place of those that the mesh brings.
inline void mark_features(const std::string& filename, CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup)
{
  soup.edges = features_of_file(filename, soup.points.size());
  soup.edge_references.assign(soup.edges.size(), 1);
  soup.edge_data.clear();
}

// Tells which edges would be sharp if the mesh marked none, but are not as it marks others; nothing if there are none.
inline std::string note_of_unmarked_edges(const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup)
{
  if(soup.edges.empty())
    return "";
  namespace internal = CGAL::Volume_mesh_parameterization::internal;
  using Edges = std::vector<std::array<std::size_t, 2> >;
  const auto facets = internal::boundary_facets_3(soup.cells);
  const auto sharp_edges = [&](const Edges& marked) // in ascending order
  { return internal::sharp_edges_3(facets, marked, [&](const std::size_t v) { return internal::to_vector(soup.points[v]); }); };
  const Edges sharp = sharp_edges(soup.edges), by_angle = sharp_edges({});
  Edges unmarked;
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
  return internal::sentence(polycube.number_of_edges_given_up(), " of ", polycube.number_of_sharp_edges,
                            " sharp edges lead along no axis of the polycube, in ", lines, lines == 1 ? " line" : " lines",
                            ", and hexahedra do not follow them: the longest leads through ",
                            internal::describe(internal::to_vector(longest[longest.size() / 2])));
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_FEATURES_H
