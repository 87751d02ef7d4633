#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_WRITE_CASE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_WRITE_CASE_H

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_writer.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>

// Writes the mesh NAME.mesh and the prescribed boundary NAME_DOMAIN.txt, as in VOLMAP.
template <typename IsOnBoundary, typename Target>
void write_case(const std::string& name, const std::string& domain,
                const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup,
                const IsOnBoundary& is_on_boundary, const Target& target)
{
  std::ofstream mesh(name + ".mesh"), boundary(name + "_" + domain + ".txt");
  CGAL::Volume_mesh_parameterization::IO::write_MEDIT(mesh, soup);
  {
    CGAL::Volume_mesh_parameterization::internal::Text_writer writer(boundary);
    for(std::size_t v = 0; v < soup.points.size(); ++v)
      if(is_on_boundary(v))
      {
        const std::array<double, 3> p = target(soup.points[v]);
        writer << v << " " << p[0] << " " << p[1] << " " << p[2] << "\n";
      }
  }
  if(!mesh.flush() || !boundary.flush())
    throw std::runtime_error(name + ": the files cannot be written");
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_WRITE_CASE_H
