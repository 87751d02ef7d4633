#ifndef NOTES_ON_HEXAHEDRA_H
#define NOTES_ON_HEXAHEDRA_H

#include "Command_line.h"
#include "Hexahedra_file.h"
#include "Progress_line.h"

#include <CGAL/Polycube_meshing_3/IO/write_hexahedron_soup.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <sstream>
#include <vector>

inline double volume(const VMP::Tetrahedron_soup_3& mesh, const std::vector<std::array<double, 3> >& points)
{
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
  const auto point = [&](const std::size_t v) { return Point_3(points[v][0], points[v][1], points[v][2]); };
  double sum = 0;
  for(const auto& cell : mesh.cells)
    sum += CGAL::volume(point(cell[0]), point(cell[1]), point(cell[2]), point(cell[3]));
  return sum;
}

// Refuses a spacing for which a polycube has far too many boxes, before there is a map: its volume is about that of the body.
inline void check_spacing(const Options& options, const VMP::Tetrahedron_soup_3& mesh)
{
  constexpr double allowance = 2; // a guess
  const double spacing = Hexahedra_file(options.hexahedra).spacing();
  const double coarser = std::cbrt(volume(mesh, mesh.points) / PM::maximum_number_of_boxes);
  if(spacing == 0 || options.domain != "polycube" || spacing > coarser / std::cbrt(allowance))
    return;
  std::ostringstream sentence;
  sentence << "with a spacing of " << spacing << ", there would be about " << PM::maximum_number_of_boxes
           * std::pow(coarser / spacing, 3) << " hexahedra. At most " << PM::maximum_number_of_boxes
           << " are allowed; use a spacing of " << 1.1 * coarser << " or more";
  throw VMP::Input_error(sentence.str());
}

// Notes what is to be expected of the hexahedra of a map: poor ones, if it distorts angles much, and many, if a polycube is much
// larger than the body.
inline void note_on_hexahedra(const Options& options, const VMP::Tetrahedron_soup_3& mesh,
                              const std::vector<std::array<double, 3> >& images, const double distortion, Progress_line& progress)
{
  constexpr double hopeless_distortion = 1000; // a guess; ten times that of bodies with good hexahedra
  constexpr double large_growth = 2;           // a guess
  if(options.is_quiet)
    return;
  progress.show("");
  if(distortion > hopeless_distortion)
    std::cerr << "note: " << options.source << ": the map distorts angles by a factor of up to " << distortion
              << ". Hexahedra of good quality are unlikely. A finer source, --refine=all or another domain may help."
              << std::endl;
  const double growth = volume(mesh, images) / volume(mesh, mesh.points);
  if(options.domain == "polycube" && growth > large_growth)
    std::cerr << "note: " << options.source << ": the polycube has " << growth << " times the volume of the body, because its "
                 "faces are at least one spacing apart. The number of hexahedra grows by this factor."
              << std::endl;
}

// Notes each name of a group that the format of Abaqus cannot hold: the old one, and the new one.
inline void note_changed_names(const Options& options, const VMP::Tetrahedron_soup_3& mesh)
{
  const std::string filename = Hexahedra_file(options.hexahedra).name();
  if(options.is_quiet || extension_of(filename) != ".inp")
    return;
  for(const auto& [group, name] : PM::IO::names_in_INP(mesh.group_names))
    if(const std::string& old_name = mesh.group_names.at(group); group.first >= 2 && name != old_name)
      std::cerr << "note: " << filename << ": the group '" << old_name << "' has the name " << name << std::endl;
}

#endif // NOTES_ON_HEXAHEDRA_H
