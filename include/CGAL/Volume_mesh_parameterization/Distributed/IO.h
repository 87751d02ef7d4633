// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_IO_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_IO_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Distributed/Distributed_tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Input_error.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/MEDIT_slice.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/MPI_communicator_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/Star_forest.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/piece_of_process.h>
#include <CGAL/Volume_mesh_parameterization/internal/Files/Text_scanner.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

namespace internal {

// Runs `read(communicator)` and puts the name of the file in front of the sentence of a failure.
template <typename Read>
void read_together(const MPI_Comm comm, const std::string& filename, const Read& read)
{
  const MPI_communicator_3 communicator(comm);
  try
  {
    communicator.together([&]() { read(communicator); return 0; });
  }
  catch(const Input_error& error)
  {
    throw Input_error(filename + ": " + error.what());
  }
}

// A number that depends on the vertices of all cells, but not on their order.
template <typename Cells>
double connectivity(const MPI_communicator_3& communicator, const Cells& cells)
{
  double sum = 0;
  for(std::array<std::size_t, 4> cell : cells)
  {
    std::sort(cell.begin(), cell.end());
    sum += static_cast<double>(boost::hash_range(cell.begin(), cell.end()) % (1 << 20)); // exact up to 2^33 cells
  }
  return communicator.sum(sum);
}

struct Target_of_vertex
{
  std::size_t vertex;
  std::array<double, 3> point;
};

inline std::vector<Target_of_vertex> read_targets(const MPI_communicator_3& communicator, const std::string& filename,
                                                  const Distributed_tetrahedron_soup_3& soup)
{
  std::vector<Target_of_vertex> result;
  if(std::filesystem::path(filename).extension() == ".mesh")
  {
    const MEDIT_slice target(communicator, filename);
    if(communicator.begins(target.points.size()).back() != communicator.begins(soup.points.size()).back()
       || communicator.begins(target.cells.size()).back() != communicator.begins(soup.cells.size()).back()
       || connectivity(communicator, target.cells) != connectivity(communicator, soup.cells))
      throw Input_error("the cells of the target join other vertices than those of the source");
    for(std::size_t i = 0; i < target.points.size(); ++i)
      result.push_back({ target.first_point + i, target.points[i] });
    return result;
  }
  const Text_slice slice(communicator, filename);
  Text_scanner scanner(slice.text, slice.first_line);
  while(scanner.has_word())
  {
    const std::size_t v = scanner.next_number<std::size_t>("the index of a vertex");
    result.push_back({ v, next_point(scanner) });
    if(scanner.has_word_on_line())
      scanner.fail("the line does not end after the three coordinates of vertex " + std::to_string(v));
  }
  return result;
}

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationDistributed
///
/// reads a tetrahedral mesh from a file in the ASCII \ref IOStreamMedit "MEDIT (.mesh) file format": each process of
/// `soup.communicator` its range of bytes; the slices of `soup` become equally long. All of them must call this function,
/// and see the file. Each vertex and each cell must have a line of its own. Triangles are not read.
///
/// \exception Input_error names the file and the line that are wrong, in all processes; `soup` is then unchanged.
inline void read_MEDIT(const std::string& filename, Distributed_tetrahedron_soup_3& soup)
{
  internal::read_together(soup.communicator, filename, [&](const internal::MPI_communicator_3& communicator)
  {
    const internal::MEDIT_slice slice(communicator, filename);
    // a range of bytes has many points and no cells, or the other way round
    Distributed_tetrahedron_soup_3 result = { soup.communicator, communicator.evenly(slice.points),
                                              communicator.evenly(slice.cells),
                                              communicator.evenly(slice.cell_references) };
    communicator.synchronize();
    std::swap(soup, result);
  });
}

/// \ingroup PkgVolumeMeshParameterizationDistributed
///
/// reads target points, each process its range of bytes: from a file `*.mesh` the points of a mesh with the vertices and
/// cells of `soup` (cells in any order), from any other file lines `vertex_index x y z`.
///
/// \param filename the name of the file, which all processes see
/// \param soup the mesh whose boundary is to be mapped
/// \param targets gets a point for each point of this slice; a vertex without a line gets not-a-number coordinates
///
/// \exception Input_error names the file and what is wrong, in all processes; `targets` is then unchanged.
inline void read_boundary_targets(const std::string& filename, const Distributed_tetrahedron_soup_3& soup,
                                  std::vector<std::array<double, 3> >& targets)
{
  internal::read_together(soup.communicator, filename, [&](const internal::MPI_communicator_3& communicator)
  {
    const std::vector<std::size_t> begins = communicator.begins(soup.points.size());
    std::vector<std::vector<internal::Target_of_vertex> > to_holders(communicator.size());
    for(const internal::Target_of_vertex& target : internal::read_targets(communicator, filename, soup))
    {
      if(target.vertex >= begins.back())
        throw Input_error("vertex " + std::to_string(target.vertex) + " does not exist, the mesh has "
                          + std::to_string(begins.back()) + " vertices, counted from 0");
      to_holders[std::upper_bound(begins.begin(), begins.end(), target.vertex) - begins.begin() - 1].push_back(target);
    }
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::array<double, 3> > points(soup.points.size(), {none, none, none});
    for(const internal::Target_of_vertex& target : communicator.exchanged(to_holders))
    {
      std::array<double, 3>& point = points[target.vertex - begins[communicator.rank()]];
      if(!std::isnan(point[0]))
        throw Input_error("vertex " + std::to_string(target.vertex) + " has a second line");
      point = target.point;
    }
    communicator.synchronize();
    targets.swap(points);
  });
}

/// \ingroup PkgVolumeMeshParameterizationDistributed
///
/// writes a distributed mesh with its parameterization for ParaView: a file `.vtu` for the cells of each process,
/// as `write_VTU()` does, and one that names them. All files appear when all are complete.
///
/// \param filename the name of the latter, `NAME.pvtu`; those of the processes are `NAME_0.vtu`, `NAME_1.vtu`, ...
/// \param soup the mesh
/// \param uvw the image of each point of the slice
///
/// \exception std::runtime_error names the file that cannot be written, in all processes.
inline void write_PVTU(const std::string& filename, const Distributed_tetrahedron_soup_3& soup,
                       const std::vector<std::array<double, 3> >& uvw)
{
  const internal::MPI_communicator_3 communicator(soup.communicator);
  const auto name_of = [&](const int rank)
  { return std::filesystem::path(filename).replace_extension().string() + "_" + std::to_string(rank) + ".vtu"; };
  std::vector<std::string> names; // of what this process writes
  try
  {
    communicator.together([&]()
    {
      const auto write = [&](const std::string& name, const auto& write_to)
      {
        names.push_back(name);
        std::ofstream os(name + ".tmp", std::ios::binary);
        write_to(os);
        os.close();
        if(!os)
          throw std::runtime_error(name + ": the file cannot be written completely");
      };
      const auto [piece, images] = internal::piece_of_process(communicator, soup, uvw);
      write(name_of(communicator.rank()), [&, &piece = piece, &images = images](std::ostream& os)
                                          { write_VTU(os, piece, images); });
      if(communicator.rank() == 0)
        write(filename, [&](std::ostream& os) { internal::write_PVTU(os, communicator.size(), name_of); });
      communicator.synchronize();
      for(const std::string& name : names)
        std::filesystem::rename(name + ".tmp", name);
      return 0;
    });
  }
  catch(...)
  {
    std::error_code ignored;
    for(const std::string& name : names)
      std::filesystem::remove(name + ".tmp", ignored);
    throw;
  }
}

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_IO_H
