// Partitions a mesh as several processes would, without running them: how many cells, vertices and neighbors would each
// have? Prints a line of comma-separated values for each number of parts.
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/MPI_communicator_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/partition_3.h>

#include <petscsys.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Cells = std::vector<VMP::internal::Global_cell_3>;

Cells cells_of(const char* filename, std::size_t& number_of_points)
{
  VMP::Tetrahedron_soup_3 soup;
  VMP::IO::read_MEDIT(filename, soup);
  number_of_points = soup.points.size();
  Cells result(soup.cells.size());
  for(std::size_t c = 0; c < result.size(); ++c)
    std::copy(soup.cells[c].begin(), soup.cells[c].end(), result[c].vertices.begin());
  return result;
}

// Counts the different second elements of each first element.
std::vector<std::size_t> numbers_of_partners(std::vector<std::pair<int, PetscInt> >& pairs, const int number_of_parts)
{
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<std::size_t> result(number_of_parts, 0);
  for(const auto& pair : pairs)
    ++result[pair.first];
  return result;
}

void print_counts(const Cells& cells, const std::vector<int>& owner, const int number_of_parts)
{
  std::vector<std::size_t> held_cells(number_of_parts, 0), own(number_of_parts, 0);
  std::vector<std::pair<int, PetscInt> > copies, neighbors; // copies and neighbors of parts
  for(const int part : owner)
    ++own[part];
  for(const VMP::internal::Global_cell_3& cell : cells)
    for(auto v = cell.begin(); v != cell.end(); ++v)
    {
      const int part = owner[*v];
      const auto has_part = [&](const PetscInt w) { return owner[w] == part; };
      held_cells[part] += std::none_of(cell.begin(), v, has_part);
      for(const PetscInt w : cell)
        if(!has_part(w))
        {
          copies.emplace_back(part, w);
          neighbors.emplace_back(part, owner[w]);
        }
    }
  const auto largest = [](const std::vector<std::size_t>& numbers)
  { return *std::max_element(numbers.begin(), numbers.end()); };
  std::cout << number_of_parts << "," << cells.size() << "," << owner.size() << "," << largest(held_cells) << ","
            << largest(own) << "," << largest(numbers_of_partners(copies, number_of_parts)) << ","
            << largest(numbers_of_partners(neighbors, number_of_parts)) << std::endl;
}

int main(int argc, char* argv[])
{
  if(argc < 3)
  {
    std::cerr << "Usage: count_halos SOURCE.mesh PARTS ..." << std::endl;
    return EXIT_FAILURE;
  }
  PetscInitialize(nullptr, nullptr, nullptr, nullptr);
  int code = EXIT_SUCCESS;
  try
  {
    const VMP::internal::MPI_communicator_3 communicator(MPI_COMM_WORLD);
    std::size_t number_of_points;
    const Cells cells = cells_of(argv[1], number_of_points);
    std::cout << "parts,cells,vertices,largest_cells,largest_vertices,largest_halo,largest_neighbors" << std::endl;
    for(int i = 2; i < argc; ++i)
    {
      const int number_of_parts = std::atoi(argv[i]);
      print_counts(cells, VMP::internal::partition_3(communicator, cells, number_of_points, number_of_parts),
                   number_of_parts);
    }
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    code = EXIT_FAILURE;
  }
  PetscFinalize();
  return code;
}
