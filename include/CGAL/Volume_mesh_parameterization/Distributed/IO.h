// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_IO_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_IO_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Distributed/Distributed_tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/partition_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Whole_file.h>

#include <filesystem>
#include <optional>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

// Lines of a file that begin in the range of bytes of this process. No slice ends before its first word, or between a keyword
// of MEDIT and its number, but takes lines from the next ones: any number of processes can read the same files.
class Text_slice
{
public:
  Text_slice(const MPI_communicator_3& communicator, const std::string& filename, const Budget& budget) : m_budget(budget)
  {
    std::error_code ignored;
    if(std::filesystem::exists(filename, ignored) && !std::filesystem::is_regular_file(filename, ignored))
      throw Input_error("this is not a regular file, of which several processes can read a part each");
    std::ifstream is(filename, std::ios::binary);
    if(!is)
      throw Input_error("the file cannot be opened");
    const std::size_t size = static_cast<std::size_t>(std::filesystem::file_size(filename));
    const std::size_t n = static_cast<std::size_t>(communicator.size()), rank = static_cast<std::size_t>(communicator.rank());
    const auto cut = [&](const std::size_t i) { return size / n * i + (std::min)(i, size % n); };
    // The first line is the one that begins in this part, or at its begin.
    if(rank > 0)
      is.seekg(static_cast<std::streamoff>(cut(rank)) - 1).ignore((std::numeric_limits<std::streamsize>::max)(), '\n');
    const std::size_t begin = is.good() ? static_cast<std::size_t>(is.tellg()) : size;
    m_text = read_text(is, budget, (std::max)(begin, cut(rank + 1)) - begin);
    // Ends the last line, and takes lines until a keyword has its number.
    std::string line;
    if(!m_text.empty() && m_text.back() != '\n' && std::getline(is, line))
      m_text += line + '\n';
    std::string last = last_word(m_text);
    while((last.empty() || MEDIT_reader::is_before_number(last)) && std::getline(is, line))
    {
      m_text += line + '\n';
      last = last_word(line).empty() ? last : last_word(line);
    }
    // Leaves to processes before this one what they took.
    const std::vector<double> ends = communicator.gathered(static_cast<double>(begin + m_text.size()));
    const auto taken = std::max_element(ends.begin(), ends.begin() + communicator.rank());
    if(rank > 0 && *taken > static_cast<double>(begin))
      m_text.erase(0, static_cast<std::size_t>(*taken) - begin);
    m_first_line = 1 + communicator.begins(std::count(m_text.begin(), m_text.end(), '\n'))[rank];
  }

  Text_scanner scanner() const { return Text_scanner(m_text, m_budget, m_first_line); }

private:
  std::string last_word(const std::string_view text) const
  {
    Text_scanner scanner(text, m_budget);
    std::string_view last;
    for(std::string_view word = scanner.next_word(); !word.empty(); word = scanner.next_word())
      last = word;
    return std::string(last);
  }

  const Budget& m_budget;
  std::string m_text;
  std::size_t m_first_line;
};

// Returns the cells of all processes with their smallest vertex in the slice of this one, as a set of vertex sets.
inline std::vector<std::array<std::size_t, 4> > sorted_cells(const MPI_communicator_3& communicator,
                                                             const std::vector<std::size_t>& begins,
                                                             const std::vector<std::array<std::size_t, 4> >& cells)
{
  std::vector<std::vector<std::array<std::size_t, 4> > > to_holders(communicator.size());
  for(const std::array<std::size_t, 4>& cell : cells)
    to_holders[communicator.holder(begins, *std::min_element(cell.begin(), cell.end()))].push_back(cell);
  return sorted_cells(communicator.exchanged(to_holders));
}

// Reads the targets of the points of the slice of this process.
inline std::vector<std::array<double, 3> > read_boundary_targets(const MPI_communicator_3& communicator,
                                                                 const std::string& filename,
                                                                 const Distributed_tetrahedron_soup_3& soup,
                                                                 const Budget& budget)
{
  const std::vector<std::size_t> begins = communicator.begins(soup.points.size());
  const Text_slice slice(communicator, filename, budget);
  if(!is_MEDIT_file(filename))
  {
    std::vector<std::vector<Target_of_vertex> > to_holders(communicator.size());
    for(const Target_of_vertex& target : read_targets(slice.scanner(), begins.back()))
      to_holders[communicator.holder(begins, target.vertex)].push_back(target);
    return points_of_vertices(communicator.exchanged(to_holders), begins[communicator.rank()], soup.points.size());
  }
  const Tetrahedron_soup_3 target = MEDIT_reader(communicator, slice.scanner()).read();
  check_same_connectivity(
    { communicator.begins(target.points.size()).back(), communicator.begins(target.cells.size()).back() },
    { begins.back(), communicator.begins(soup.cells.size()).back() }, [&]
  {
    return communicator.all(sorted_cells(communicator, begins, target.cells)
                            == sorted_cells(communicator, begins, soup.cells));
  });
  return communicator.redistributed(target.points, begins);
}

// Refuses arrays that do not fit together, as `IO::write_VTU()` does, in any slice.
inline void check_piece(const MPI_communicator_3& communicator, const Distributed_tetrahedron_soup_3& soup,
                        const std::vector<std::array<double, 3> >& uvw)
{
  const std::size_t number_of_points = communicator.begins(soup.points.size()).back();
  const std::size_t first = communicator.begins(soup.cells.size())[communicator.rank()];
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    check_simplex(soup.cells[c], number_of_points, "cell ", first + c);
  if(soup.cell_references.size() != soup.cells.size())
    throw Input_error("there is not one reference per cell");
  require(uvw.size() == soup.points.size(), "uvw must have an element for each point.");
}

// Writes the cells of this process with their points and images, as `IO::write_VTU()` does.
inline void write_piece(std::ostream& os, const MPI_communicator_3& communicator,
                        const Distributed_tetrahedron_soup_3& soup, const std::vector<std::array<double, 3> >& uvw)
{
  const std::vector<PetscInt> vertices = sorted_vertices(soup.cells);
  const Star_forest star_forest(communicator, soup.points.size(), vertices);
  Tetrahedron_soup_3 piece = { star_forest.get(soup.points), soup.cells, soup.cell_references, {}, {} };
  for(std::array<std::size_t, 4>& cell : piece.cells)
    for(std::size_t& v : cell)
      v = index_in(vertices, static_cast<PetscInt>(v));
  const std::vector<std::array<double, 3> > images = star_forest.get(uvw);
  write_VTU(os, piece, images,
            communicator.sum(volume(piece.cells, images)) / communicator.sum(volume(piece.cells, piece.points)));
}

// Writes the file that names the pieces and their arrays.
inline void write_PVTU(std::ostream& os, const std::vector<std::string>& pieces)
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
  for(const std::string& piece : pieces)
    os << "<Piece Source=\"" << XML_escaped(std::filesystem::path(piece).filename().string()) << "\"/>\n";
  os << "</PUnstructuredGrid>\n</VTKFile>\n";
}

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationDistributed
///
/// reads a tetrahedral mesh from a file in the ASCII \ref IOStreamMedit "MEDIT (.mesh) file format". Each process of
/// `soup.communicator` reads its range of bytes. The slices of `soup` become equally long. All of them must call this function,
/// and see the file, which must be a regular one. Each vertex, triangle and cell must have a line of its own; otherwise a file
/// is read as by one process. Triangles are left out.
///
/// \param filename the name of the file
/// \param soup gets the mesh
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `maximum_running_time` and `visitor`
///
/// \return `false` in all processes if the time is over or the visitor ends the reading in one of them; `soup` is then unchanged.
///
/// \exception Input_error names the file and the line that are wrong, in all processes; \c soup is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_MEDIT(const std::string& filename, Distributed_tetrahedron_soup_3& soup,
                const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, filename, [&](const internal::Budget& budget)
  {
    const internal::MPI_communicator_3 communicator(soup.communicator);
    soup = communicator.together([&]() -> Distributed_tetrahedron_soup_3
    {
      const internal::Text_slice slice(communicator, filename, budget);
      const Tetrahedron_soup_3 part = internal::MEDIT_reader(communicator, slice.scanner()).read();
      // a range of bytes has many points and no cells, or the other way round
      return { soup.communicator, communicator.evenly(part.points), communicator.evenly(part.cells),
               communicator.evenly(part.cell_references) };
    });
  });
}

/// \ingroup PkgVolumeMeshParameterizationDistributed
///
/// reads target points, each process its range of bytes. A file `*.mesh` contains the points of a mesh with the vertices and
/// cells of `soup`, with cells in any order. Any other file has lines `vertex_index x y z`.
///
/// \param filename the name of the file, which all processes see
/// \param soup the mesh whose boundary is to be mapped
/// \param targets gets a point for each point of this slice; a vertex without a line gets not-a-number coordinates
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `read_MEDIT()`
///
/// \return `false` if the time is over or the visitor ends the reading; `targets` is then unchanged.
///
/// \exception Input_error names the file and what is wrong, in all processes; \c targets is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_boundary_targets(const std::string& filename, const Distributed_tetrahedron_soup_3& soup,
                           std::vector<std::array<double, 3> >& targets,
                           const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, filename, [&](const internal::Budget& budget)
  {
    const internal::MPI_communicator_3 communicator(soup.communicator);
    targets = communicator.together([&] { return internal::read_boundary_targets(communicator, filename, soup, budget); });
  });
}

/// \ingroup PkgVolumeMeshParameterizationDistributed
///
/// returns the name of the file to which `write_PVTU()` writes the cells of a process: `NAME_0.vtu`, `NAME_1.vtu`, ...
///
/// \param filename the name of the file that names them, `NAME.pvtu`
/// \param rank the number of the process
inline std::string name_of_piece(const std::string& filename, const int rank)
{ return std::filesystem::path(filename).replace_extension().string() + "_" + std::to_string(rank) + ".vtu"; }

/// \ingroup PkgVolumeMeshParameterizationDistributed
///
/// writes a distributed mesh with its parameterization for ParaView. Each process writes a file `.vtu` for its cells, as
/// `write_VTU()` does. Another file names these files. All files appear when all are complete.
///
/// \param filename the name of the file that names the others, `NAME.pvtu`; `name_of_piece()` returns those
/// \param soup the mesh
/// \param uvw the image of each point of the slice
///
/// \exception Input_error if an index does not exist, or a reference is missing, in all processes. No file is written.
/// \exception std::runtime_error names a file that cannot be written, or a process with fewer or more images than points. All
///            processes throw it.
inline void write_PVTU(const std::string& filename, const Distributed_tetrahedron_soup_3& soup,
                       const std::vector<std::array<double, 3> >& uvw)
{
  const internal::MPI_communicator_3 communicator(soup.communicator);
  std::vector<std::string> pieces; // pieces of all processes
  for(int rank = 0; rank < communicator.size(); ++rank)
    pieces.push_back(name_of_piece(filename, rank));
  communicator.together([&]()
  {
    internal::check_piece(communicator, soup, uvw);
    internal::Whole_file piece(pieces[communicator.rank()]);
    internal::write_piece(piece.stream(), communicator, soup, uvw);
    piece.complete();
    std::optional<internal::Whole_file> list;
    if(communicator.rank() == 0)
    {
      list.emplace(filename);
      internal::write_PVTU(list->stream(), pieces);
      list->complete();
    }
    communicator.synchronize();
    piece.commit();
    if(list)
      list->commit();
    return 0;
  });
}

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_IO_H
