// Functions that need Gmsh, in a module that is loaded where a file asks for it: the hundred libraries that Gmsh brings would
// take longer to load than small meshes to map.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_GMSH_MODULE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_GMSH_MODULE_H

#include <CGAL/Polycube_meshing_3/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <dlfcn.h>

#include <map>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>

struct Gmsh_module
{
  void (*read)(const std::string& filename, CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup);
  void (*fill)(const std::string& filename, CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup, double cell_size,
               double joining_distance, int number_of_failures, bool do_fill_voids);
  void (*write)(std::ostream& os, const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup, double version);
  void (*write_hexahedra)(std::ostream& os, const CGAL::Polycube_meshing_3::Hexahedron_soup_3& mesh,
                          const std::map<std::pair<int, int>, std::string>& names, double version);
};

inline const Gmsh_module& gmsh_module()
{
  static const Gmsh_module* const result = []
  {
    void* const library = dlopen("parameterize_mesh_file_Gmsh.so", RTLD_NOW); // in a folder that the program knows
    const void* const module = library == nullptr ? nullptr : dlsym(library, "functions_of_Gmsh_module");
    if(module == nullptr)
      throw std::runtime_error(std::string("Gmsh cannot be loaded: ") + dlerror());
    return static_cast<const Gmsh_module*>(module);
  }();
  return *result;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_GMSH_MODULE_H
