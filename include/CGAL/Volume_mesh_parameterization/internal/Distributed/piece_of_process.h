// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PIECE_OF_PROCESS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PIECE_OF_PROCESS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Distributed/Distributed_tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/MPI_communicator_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/Star_forest.h>

#include <petscsystypes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The cells of this process with their points and the images of these.
inline std::pair<Tetrahedron_soup_3, std::vector<std::array<double, 3> > >
piece_of_process(const MPI_communicator_3& communicator, const Distributed_tetrahedron_soup_3& soup,
                 const std::vector<std::array<double, 3> >& uvw)
{
  const std::vector<PetscInt> vertices = sorted_vertices(soup.cells);
  const Star_forest star_forest(communicator, soup.points.size(), vertices);
  Tetrahedron_soup_3 piece = { star_forest.get(soup.points), soup.cells, soup.cell_references, {}, {} };
  for(std::array<std::size_t, 4>& cell : piece.cells)
    for(std::size_t& v : cell)
      v = static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), static_cast<PetscInt>(v))
                                   - vertices.begin());
  return { std::move(piece), star_forest.get(uvw) };
}

// Names the files of all processes, which have the arrays of `IO::write_VTU()`.
template <typename NameOf>
void write_PVTU(std::ostream& os, const int number_of_processes, const NameOf& name_of)
{
  os << "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<PUnstructuredGrid GhostLevel=\"0\">\n"
        "<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n</PPoints>\n"
        "<PPointData>\n<PDataArray type=\"Float64\" Name=\"uvw\" NumberOfComponents=\"3\"/>\n</PPointData>\n"
        "<PCellData>\n<PDataArray type=\"Int32\" Name=\"reference\"/>\n";
  for(const char* name : { "angle_distortion", "volume_distortion", "det_J" })
    os << "<PDataArray type=\"Float64\" Name=\"" << name << "\"/>\n";
  os << "</PCellData>\n";
  for(int rank = 0; rank < number_of_processes; ++rank)
    os << "<Piece Source=\"" << std::filesystem::path(name_of(rank)).filename().string() << "\"/>\n";
  os << "</PUnstructuredGrid>\n</VTKFile>\n";
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PIECE_OF_PROCESS_H
