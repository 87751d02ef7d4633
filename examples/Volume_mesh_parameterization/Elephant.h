// A tetrahedral mesh of CGAL's elephant, and what is told of a map of it.
#ifndef ELEPHANT_H
#define ELEPHANT_H

#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_3<Surface_mesh, K>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;

// It is compiled once for both programs, as make_mesh_3() takes longer to compile than the rest of each.
C3t3 mesh_elephant(const std::string& filename);

// Prints the result, writes the map to a file, and returns the exit code of the program.
template <typename VertexUVWMap>
int report(const C3t3& c3t3, const VertexUVWMap uvw_map,
           const CGAL::Volume_mesh_parameterization::Parameterization_result& result, const std::string& filename)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;

  std::cout << result.message << "\n"
            << result.number_of_cells << " cells, " << result.number_of_inverted_cells << " of them inverted\n"
            << "distortion of angles:  mean " << result.distortion.angle_mean
            << ", max " << result.distortion.angle_max << "\n"
            << "distortion of volumes: mean " << result.distortion_at_source_volume.volume_mean
            << ", max " << result.distortion_at_source_volume.volume_max << std::endl;
  if(result.status != VMP::OK)
    return EXIT_FAILURE;

  std::ofstream out(filename);
  VMP::IO::write_VTU(out, c3t3, uvw_map);
  out.close();
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif // ELEPHANT_H
