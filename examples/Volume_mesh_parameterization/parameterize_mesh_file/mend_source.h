// Names the faults of a mesh, and mends them if that is safe or requested.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MEND_SOURCE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MEND_SOURCE_H

#include "Command_line.h"
#include "Mesh_format.h"
#include "Named_choices.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/repair_tetrahedron_soup.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using Points = std::vector<std::array<double, 3> >;

// Counts of what was found in a mesh and mended.
struct Repairs
{
  std::size_t number_of_coinciding_points = 0; // on the boundary
  std::size_t number_of_merged_points = 0, number_of_turned_cells = 0, number_of_separated_vertices = 0;
  std::size_t number_of_tangled_cells = 0;     // that are inverted or flat
};

// Mesh of a file, with positive cells, each once.
struct Source
{
  VMP::Tetrahedron_soup_3 soup;
  // the mesh of the file, if cells have other vertices now
  std::optional<VMP::Tetrahedron_soup_3> unmended = {};
  std::vector<std::size_t> first_points = {}; // for each point the merged one that has its cells now; or empty
  double joining_distance = 0;                // up to which points are merged
  // the edge or, twice, the vertex that each appended point was
  std::vector<std::array<std::size_t, 2> > origins = {};
  Repairs repairs = {};
  std::vector<std::string> notes = {};

  // Returns the mesh that other files refer to, with the vertices and cells of its file.
  const VMP::Tetrahedron_soup_3& in_file() const { return unmended ? *unmended : soup; }

  // Returns the vertices of the mesh that a vertex of the file has become; none if there is no such vertex in the file.
  std::vector<std::size_t> vertices_of(const std::size_t v) const
  {
    const std::size_t n = in_file().points.size();
    if(v >= n)
      return {};
    std::vector<std::size_t> result = { first_points.empty() ? v : first_points[v] };
    for(std::size_t i = 0; i < origins.size(); ++i)
      if(origins[i] == std::array{ result.front(), result.front() })
        result.push_back(n + i);
    return result;
  }

  // Takes points of the file to the mesh. A point without one has coordinates that are not numbers.
  Points carried(Points points) const
  {
    for(std::size_t v = 0; v < first_points.size(); ++v)
    {
      std::array<double, 3>& point = points[first_points[v]];
      if(std::isnan(point[0]))
        point = points[v];
      else if(!std::isnan(points[v][0]) && !are_near(points[v], point))
        throw VMP::Input_error("vertices " + std::to_string(first_points[v]) + " and " + std::to_string(v)
                               + " (counted from 0) are merged, but have different points here");
    }
    for(const auto& [v, w] : origins)
    {
      points.push_back(std::array<double, 3>(points[v]));
      for(std::size_t i = 0; i < 3 && v != w; ++i)
        points.back()[i] = (points[v][i] + points[w][i]) / 2;
    }
    return points;
  }

  bool are_near(const std::array<double, 3>& p, const std::array<double, 3>& q) const
  { return p == q || std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= joining_distance; }

  // Gives points without cells the images of those that have theirs.
  void complete_images(Points& images) const
  {
    for(std::size_t v = 0; v < first_points.size(); ++v)
      images[v] = images[first_points[v]];
  }
};

// Returns the points or cells that equal one before them.
inline std::vector<std::size_t> repeated(const std::vector<std::size_t>& first)
{
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < first.size(); ++i)
    if(first[i] != i)
      result.push_back(i);
  return result;
}

inline void merge_points(Source& source)
{
  source.unmended = source.soup;
  source.first_points = VMP::merge_coinciding_points(source.soup, source.joining_distance);
  source.repairs.number_of_merged_points = repeated(source.first_points).size();
  source.notes.push_back(counted(source.repairs.number_of_merged_points, "point has the position of another point, and is",
                                 "points have the position of another point, and are")
                         + (source.joining_distance > 0 ? " merged with it; or nearly its position" : " merged with it"));
}

// Advice for cells that are inverted or flat, behind the reason.
const std::string advice_to_improve = "--improve -o FILE moves interior vertices until no cell is inverted or flat. With "
  "--refine, it also splits cells whose vertices are all on the boundary";

inline void note_turned_cells(Source& source)
{
  const std::size_t n = source.repairs.number_of_turned_cells, all = source.soup.cells.size();
  if(n == 0)
    return;
  source.notes.push_back(n == all ? "all " + std::to_string(n) + " cells are negative and are turned. The written files have "
                                    "positive cells"
                                  : std::to_string(n) + " of " + std::to_string(all) + " cells were reversed and are turned");
}

inline std::size_t number_of_tangled_cells(const VMP::Tetrahedron_soup_3& soup)
{
  std::size_t result = 0;
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
  {
    const auto point = [&](const std::size_t i)
    {
      const auto& [x, y, z] = soup.points[soup.cells[c][i]];
      return CGAL::Exact_predicates_inexact_constructions_kernel::Point_3(x, y, z);
    };
    result += CGAL::orientation(point(0), point(1), point(2), point(3)) != CGAL::POSITIVE;
  }
  return result;
}

// Turns reversed cells. Those that are flat or inverted then are counted, or refused.
inline void turn_cells(Source& source, const bool may_be_tangled)
{
  try
  {
    source.repairs.number_of_turned_cells = VMP::orient_tetrahedron_soup<Concurrency_tag>(source.soup);
  }
  catch(const VMP::Input_error&)
  {
    source.repairs.number_of_turned_cells = VMP::orient_tetrahedron_soup_by_facets(source.soup);
    source.repairs.number_of_tangled_cells = number_of_tangled_cells(source.soup);
  }
  note_turned_cells(source);
  if(source.repairs.number_of_tangled_cells == 0 || may_be_tangled)
    return;
  try { VMP::orient_tetrahedron_soup<Concurrency_tag>(source.soup); }
  catch(const VMP::Input_error& error)
  {
    throw VMP::Input_error((source.repairs.number_of_turned_cells == 0 ? "" : source.notes.back() + "; ") + error.what() + "; "
                           + advice_to_improve);
  }
}

inline void separate(Source& source)
{
  if(!source.unmended)
    source.unmended = source.soup;
  const auto separate_vertices = [&]
  {
    for(const std::size_t v : VMP::separate_pinched_vertices(source.soup))
      source.origins.push_back({ v, v });
  };
  separate_vertices();
  if(const auto edges = VMP::split_pinched_edges(source.soup); !edges.empty())
  {
    source.origins.insert(source.origins.end(), edges.begin(), edges.end());
    separate_vertices();
  }
  source.repairs.number_of_separated_vertices = source.origins.size();
  source.notes.push_back(source.origins.empty()
    ? "there are no parts to separate, because facets join the cells around each vertex"
    : counted(source.origins.size(), "vertex was", "vertices were") + " added to separate parts of the body");
}

// Leaves out cells with the vertices of one before them. Numbers of cells in messages do not count them.
inline void merge_cells(Source& source)
{
  VMP::Tetrahedron_soup_3 merged = source.soup;
  if(repeated(VMP::merge_coinciding_cells<Concurrency_tag>(merged)).empty())
    return;
  std::swap(source.soup, merged);
  if(!source.unmended)
    source.unmended = std::move(merged);
  source.notes.push_back(source.soup.notes.back());
}

inline void leave_out_flat_cells(Source& source)
{
  VMP::Tetrahedron_soup_3 before = source.soup;
  if(VMP::remove_flat_boundary_cells(source.soup) == 0)
    return;
  if(!source.unmended)
    source.unmended = std::move(before);
  source.notes.push_back(source.soup.notes.back());
}

// Counts boundary vertices with the same coordinates: perhaps the body should be one there. Facets are matched only where any
// points coincide, as this takes far longer.
inline void count_coinciding_points(Source& source)
{
  const auto first_at_points = [](const Points& points)
  {
    VMP::Tetrahedron_soup_3 of_points;
    of_points.points = points;
    return VMP::merge_coinciding_points(of_points);
  };
  if(repeated(first_at_points(source.soup.points)).empty())
    return;
  const std::vector<std::size_t> vertices = VMP::boundary_vertices(source.soup.points, source.soup.cells);
  Points points;
  for(const std::size_t v : vertices)
    points.push_back(source.soup.points[v]);
  const std::vector<std::size_t> first = first_at_points(points), others = repeated(first);
  source.repairs.number_of_coinciding_points = others.size();
  if(!others.empty())
    source.notes.push_back(counted(others.size(), "vertex of the boundary has", "vertices of the boundary have")
      + " the position of another one. For example, vertex " + std::to_string(vertices[others.back()])
      + " has the position of vertex " + std::to_string(vertices[first[others.back()]]) + " (counted from 0). The "
        "body is torn there; --merge-points joins it");
}

inline Source mended_source(VMP::Tetrahedron_soup_3 soup, const Options& options)
{
  Source source = { std::move(soup) };
  source.notes = source.soup.notes;
  source.joining_distance = options.joining_distance;
  if(options.do_merge_points && !is_body_name(options.source))
    merge_points(source);
  merge_cells(source);
  if(options.do_leave_out_flat_cells)
    leave_out_flat_cells(source);
  turn_cells(source, options.do_improve);
  if(options.do_separate)
    separate(source);
  else
    count_coinciding_points(source);
  return source;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MEND_SOURCE_H
