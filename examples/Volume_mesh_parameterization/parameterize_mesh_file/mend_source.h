// Tells the faults of a mesh, and mends them where that is safe or asked for.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MEND_SOURCE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MEND_SOURCE_H

#include "Command_line.h"
#include "Named_choices.h"

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/merge_coinciding_points.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/separate_pinched_vertices.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using Points = std::vector<std::array<double, 3> >;

// Mesh of a file, in its order, with positive cells.
struct Source
{
  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 soup;
  // the mesh of the file, if cells have other vertices now
  std::optional<CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3> unmended = {};
  std::vector<std::size_t> first_points = {}; // for each point the one with the same coordinates that has its cells now; or empty
  std::vector<std::size_t> origins = {};      // origin of each point that was appended
  bool is_turned = false;                     // whether the cells are negative in the file, and in files that are written
  std::size_t number_of_coinciding_points = 0; // coinciding points on the boundary
  std::size_t number_of_merged_points = 0;
  std::size_t number_of_tangled_cells = 0; // cells that are inverted or flat
  std::size_t number_of_turned_cells = 0; // cells turned alone, not all together
  std::vector<std::string> notes = {};

  // Returns the mesh that other files refer to, with the vertices and cells of its file.
  const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& in_file() const { return unmended ? *unmended : soup; }

  // Takes points of the file to the mesh. A point that is not told has coordinates that are not numbers.
  Points carried(Points points) const
  {
    for(std::size_t v = 0; v < first_points.size(); ++v)
      if(std::isnan(points[first_points[v]][0]))
        points[first_points[v]] = points[v];
    for(const std::size_t v : origins)
      points.push_back(std::array<double, 3>(points[v]));
    return points;
  }

  // Gives points without cells the images of those that have theirs.
  void complete_images(Points& images) const
  {
    for(std::size_t v = 0; v < first_points.size(); ++v)
      images[v] = images[first_points[v]];
  }

  // Returns the mesh with the orientation that cells have in the file.
  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 oriented_as_in_file() const
  {
    auto result = soup;
    for(std::array<std::size_t, 4>& cell : result.cells)
      if(is_turned)
        std::swap(cell[2], cell[3]);
    return result;
  }
};

// Returns the points that have the place of one before them.
inline std::vector<std::size_t> repeated_points(const std::vector<std::size_t>& first_points)
{
  std::vector<std::size_t> result;
  for(std::size_t v = 0; v < first_points.size(); ++v)
    if(first_points[v] != v)
      result.push_back(v);
  return result;
}

inline void merge_points(Source& source)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  source.unmended = source.soup;
  source.first_points = VMP::merge_coinciding_points(source.soup);
  source.number_of_merged_points = repeated_points(source.first_points).size();
  source.notes.push_back(std::to_string(source.number_of_merged_points)
                         + " points have the place of another one, and are merged with it");
}

// Turns all cells if their volumes have a negative sum, and counts those that are inverted or flat then.
inline void turn_tangled_cells(Source& source)
{
  double volume = 0;
  for(std::size_t c = 0; c < source.soup.cells.size(); ++c)
  {
    const auto [p, q, r, s] = CGAL::Volume_mesh_parameterization::internal::cell_points(source.soup, c);
    volume += CGAL::volume(p, q, r, s);
  }
  source.is_turned = volume < 0;
  source.soup = source.oriented_as_in_file();
  for(std::size_t c = 0; c < source.soup.cells.size(); ++c)
  {
    const auto [p, q, r, s] = CGAL::Volume_mesh_parameterization::internal::cell_points(source.soup, c);
    source.number_of_tangled_cells += CGAL::orientation(p, q, r, s) != CGAL::POSITIVE;
  }
}

// Advises where cells are inverted or flat, behind the reason.
const std::string advice_to_improve = "--improve -o FILE moves vertices inside such that no cell is inverted or flat, and with "
  "--refine also splits cells whose vertices are all on the boundary";

// Orients the cells. A cell that is turned alone stays so; if all are turned, files are written with the orientation of the
// file.
inline void turn_cells(Source& source, const bool may_be_tangled)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  VMP::internal::check_points(source.soup);
  VMP::internal::check_simplices(source.soup);
  std::size_t number;
  try
  {
    number = VMP::orient_tetrahedron_soup<Concurrency_tag>(source.soup);
  }
  catch(const VMP::Input_error& error)
  {
    if(!may_be_tangled)
      throw VMP::Input_error(error.what() + ("; " + advice_to_improve));
    turn_tangled_cells(source);
    return;
  }
  source.is_turned = number > 0 && number == source.soup.cells.size();
  source.number_of_turned_cells = source.is_turned ? 0 : number;
  if(source.number_of_turned_cells > 0)
    source.notes.push_back(std::to_string(number) + " of " + std::to_string(source.soup.cells.size())
                           + " cells were reversed, and are turned");
}

inline void separate(Source& source)
{
  if(!source.unmended)
    source.unmended = source.soup;
  source.origins = CGAL::Volume_mesh_parameterization::separate_pinched_vertices(source.soup);
  source.notes.push_back(std::to_string(source.origins.size())
                         + " vertices are added where the body touches itself, so that it does no more");
}

// Counts boundary vertices with the same coordinates: perhaps the body should be one there. Facets are matched only where any
// points coincide, as this takes far longer.
inline void count_coinciding_points(Source& source)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  if(repeated_points(VMP::first_coinciding_points(source.soup.points)).empty())
    return;
  const std::vector<std::size_t> vertices = VMP::boundary_vertices(source.soup.points, source.soup.cells);
  Points points;
  for(const std::size_t v : vertices)
    points.push_back(source.soup.points[v]);
  const std::vector<std::size_t> first = VMP::first_coinciding_points(points), repeated = repeated_points(first);
  source.number_of_coinciding_points = repeated.size();
  if(!repeated.empty())
    source.notes.push_back(std::to_string(repeated.size()) + " vertices of the boundary have the place of another one, as vertex "
      + std::to_string(vertices[repeated.back()]) + " has that of vertex " + std::to_string(vertices[first[repeated.back()]])
      + " (counted from 0): the body is torn there, unless --merge-points joins it");
}

inline Source mended_source(CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 soup, const Options& options)
{
  Source source = { std::move(soup) };
  source.notes = source.soup.notes;
  if(options.do_merge_points)
    merge_points(source);
  turn_cells(source, options.do_improve);
  if(options.do_separate)
    separate(source);
  else
    count_coinciding_points(source);
  return source;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MEND_SOURCE_H
