#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_WRITE_CASE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_WRITE_CASE_H

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>

// Writes NAME.mesh.
inline void write_mesh(const std::string& name, const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup)
{
  if(!CGAL::Volume_mesh_parameterization::IO::write_MEDIT(name + ".mesh", soup))
    throw std::runtime_error(name + ".mesh: this file cannot be written");
}

// Writes the prescribed boundary NAME_DOMAIN.txt, as in VOLMAP, for vertices with indices below n.
template <typename IsOnBoundary, typename Target>
void write_targets(const std::string& name, const std::string& domain, const std::size_t n,
                   const IsOnBoundary& is_on_boundary, const Target& target)
{
  std::ofstream out(name + "_" + domain + ".txt");
  {
    CGAL::Volume_mesh_parameterization::internal::Text_writer writer(out);
    for(std::size_t v = 0; v < n; ++v)
      if(is_on_boundary(v))
      {
        const std::array<double, 3> p = target(v);
        writer << v << " " << p[0] << " " << p[1] << " " << p[2] << "\n";
      }
  }
  if(!out.flush())
    throw std::runtime_error(name + "_" + domain + ".txt: this file cannot be written");
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_WRITE_CASE_H
