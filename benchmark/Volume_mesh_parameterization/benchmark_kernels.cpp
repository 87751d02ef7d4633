// Times the kernels of the solver on one thread, beside the peaks of the machine that the same program measures.
#include "Counting_number.h"
#include "Grid_problem.h"
#include "machine_peak.h"

#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_kernels_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Untangling_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Newton_system_3.h>

#include <Eigen/Core>

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

using namespace CGAL::Volume_mesh_parameterization;
using namespace CGAL::Volume_mesh_parameterization::internal;

using Counted_vector = arithmetic_of_unit::Vector_3<Counting_number>;
using Counted_matrix = arithmetic_of_unit::Matrix_3<Counting_number>;
using Counted_decomposition = arithmetic_of_unit::Signed_singular_values_3<Counting_number>;
using Vector_of_energy = Eigen::Matrix<Counting_number, 3, 1>; // energies have vectors of Eigen
using Matrix_of_energy = Eigen::Matrix<Counting_number, 3, 3>;

Grid_problem& problem(const std::size_t n)
{
  static std::map<std::size_t, Grid_problem> problems;
  return problems.try_emplace(n, n).first->second;
}

// Work of a call: the operations to compute, and the bytes to move if nothing stays in a cache between two passes.
struct Work
{
  double operations, bytes;
};

void measure(benchmark::State& state, const Grid_problem& p, const Work& work, const std::function<void()>& kernel)
{
  static const double peak_flops = measure_peak_flops();
  static const double peak_bandwidth = measure_peak_bandwidth();

  const double begin = processor_seconds();
  for(auto _ : state)
    kernel();
  const double seconds = (processor_seconds() - begin) / static_cast<double>(state.iterations());

  const double cells = static_cast<double>(p.mesh.cells.size());
  state.counters["ns/cell"] = 1e9 * seconds / cells;
  state.counters["flop/cell"] = work.operations / cells;
  state.counters["GFLOP/s"] = 1e-9 * work.operations / seconds;
  state.counters["peak GFLOP/s"] = 1e-9 * peak_flops;
  state.counters["% of GFLOP/s"] = 100 * work.operations / seconds / peak_flops;
  state.counters["GB/s"] = 1e-9 * work.bytes / seconds;
  state.counters["peak GB/s"] = 1e-9 * peak_bandwidth;
  state.counters["% of GB/s"] = 100 * work.bytes / seconds / peak_bandwidth;
}

// The operations of f(J, inverse_source, number of free vertices) for all cells, by a sample of them.
template <typename Function>
double count_cells(const Grid_problem& p, const Function& f)
{
  const std::size_t stride = 1 + p.mesh.cells.size() / 2048;
  std::size_t sum = 0, number_of_samples = 0;
  for(std::size_t c = 0; c < p.mesh.cells.size(); c += stride, ++number_of_samples)
  {
    const std::array<int, 4>& cell = p.mesh.cells[c];
    Counted_matrix inverse_source;
    for(int k = 0; k < 3; ++k)
      for(int i = 0; i < 3; ++i)
        inverse_source(i, k) = p.cells.inverse_sources[c](i, k);
    int number_of_free_vertices = 0;
    for(const int v : cell)
      number_of_free_vertices += p.mesh.is_free(v);
    sum += count_operations([&]
    {
      Counted_matrix U;
      for(int k = 0; k < 3; ++k)
        for(int i = 0; i < 3; ++i)
          U(i, k) = Counting_number(p.u(i, cell[k + 1])) - Counting_number(p.u(i, cell[0]));
      f(product(U, inverse_source), inverse_source, number_of_free_vertices);
    });
  }
  return static_cast<double>(sum) * static_cast<double>(p.mesh.cells.size()) / static_cast<double>(number_of_samples);
}

double bytes_of_packs(const Grid_problem& p, const std::size_t bytes_per_pack)
{
  return static_cast<double>(p.packs.number_of_packs() * bytes_per_pack);
}

double bytes_of_positions(const Grid_problem& p)
{
  return static_cast<double>(sizeof(double)) * static_cast<double>(p.u.size());
}

double number_of_blocks(const Grid_problem& p)
{
  return p.hessian.row_end(p.hessian.size() - 1);
}

constexpr std::size_t geometry_bytes = sizeof(Cell_pack_3::vertices) + sizeof(Cell_pack_3::inverse_source);

Counted_decomposition decomposed(const Counted_matrix& J)
{
  Counted_decomposition result;
  decompose(J, result);
  return result;
}

Vector_of_energy to_energy(const Counted_vector& s)
{
  return Vector_of_energy(s[0], s[1], s[2]);
}

Counted_vector from_energy(const Vector_of_energy& g)
{
  return Counted_vector(g[0], g[1], g[2]);
}

void singular_values(benchmark::State& state, Grid_problem& p)
{
  const double operations = count_cells(p, [](const Counted_matrix& J, const Counted_matrix&, int)
  {
    decomposed(J);
  });
  measure(state, p, {operations, bytes_of_packs(p, geometry_bytes) + bytes_of_positions(p)}, [&]
  {
    Pack largest(0);
    for(std::size_t chunk = 0; chunk < p.packs.number_of_chunks(); ++chunk)
      for(const Cell_pack_3* pack = p.packs.chunk_begin(chunk); pack != p.packs.chunk_end(chunk); ++pack)
        for(int first = 0; first < cells_per_pack; first += Pack::size)
        {
          arithmetic_of_unit::Signed_singular_values_3<Pack> J;
          decompose(arithmetic_of_unit::jacobian(p.u.data(), *pack, first), J);
          largest = maximum(largest, J.s[0]);
        }
    benchmark::DoNotOptimize(largest);
  });
}

template <typename Energy>
void evaluate(benchmark::State& state, Grid_problem& p, const Energy& energy)
{
  const double operations = count_cells(p, [&](const Counted_matrix& J, const Counted_matrix&, int)
  {
    const Counted_vector norms = norms_3(J);
    Counting_number sum = 0;
    sum += Counting_number(1) * energy.value_of_norms(norms[0], norms[1], norms[2]);
  });
  const double bytes = bytes_of_packs(p, geometry_bytes + sizeof(Cell_pack_3::weight)) + bytes_of_positions(p);
  const Cell_energy_of<Energy> cell_energy(energy);
  measure(state, p, {operations, bytes}, [&]
  {
    benchmark::DoNotOptimize(evaluate_energy(p.packs, cell_energy, p.u));
  });
}

template <typename Energy>
void assemble(benchmark::State& state, Grid_problem& p, const Energy& energy, const double negative_curvature)
{
  const double operations = count_cells(p, [&](const Counted_matrix& J, const Counted_matrix& inverse_source, int m)
  {
    const Counted_decomposition d = decomposed(J);
    const Vector_of_energy s = to_energy(d.s);
    const Counted_vector g = from_energy(energy.gradient(s));
    const Matrix_of_energy columns = energy.hessian(s);
    const Counted_matrix H = {from_energy(columns.col(0)), from_energy(columns.col(1)), from_energy(columns.col(2))};
    arithmetic_of_unit::Cell_derivatives_3<Counting_number> cell;
    cell_derivatives_3(distortion_derivatives_3(d.s, g, H, negative_curvature), d.R, product(inverse_source, d.Q),
                       Counting_number(1), cell);
    Counting_number::count() += 3 * m + 9 * m * (m + 1) / 2; // additions to the gradient and to the Hessian
  });
  // gradient: cleared and updated; Hessian: cleared, one half updated and copied to the other
  const double bytes = bytes_of_packs(p, sizeof(Cell_pack_3)) + bytes_of_positions(p)
                     + 3. * sizeof(double) * static_cast<double>(p.gradient.size())
                     + number_of_blocks(p) * (3. * 9 * sizeof(Grid_problem::Matrix::NT) + sizeof(int));
  const Cell_energy_of<Energy> cell_energy(energy);
  measure(state, p, {operations, bytes}, [&]
  {
    assemble_energy(p.packs, cell_energy, p.u, negative_curvature, p.gradient, p.hessian);
    benchmark::ClobberMemory();
  });
}

void largest_step(benchmark::State& state, Grid_problem& p)
{
  const double operations = count_cells(p, [](const Counted_matrix& J, const Counted_matrix& inverse_source, int)
  {
    determinant_polynomial_3(J, product(J, inverse_source)); // dJ costs as many operations as J itself
  });
  const Eigen::Matrix3Xd direction = 0.1 * p.u;
  measure(state, p, {operations, bytes_of_packs(p, geometry_bytes) + 2 * bytes_of_positions(p)}, [&]
  {
    benchmark::DoNotOptimize(largest_step_3(p.packs, p.u, direction));
  });
}

void matrix_product(benchmark::State& state, Grid_problem& p)
{
  using NT = Grid_problem::Matrix::NT;
  const Cell_energy_of<Stretch_energy_3> energy{Stretch_energy_3()};
  assemble_energy(p.packs, energy, p.u, 0., p.gradient, p.hessian);
  const std::size_t n = 3 * static_cast<std::size_t>(p.hessian.size());
  std::vector<NT> x(n + 1, NT(1)), y(n);
  const double bytes = number_of_blocks(p) * (9. * sizeof(NT) + sizeof(int)) + 2. * sizeof(NT) * static_cast<double>(n);
  measure(state, p, {18 * number_of_blocks(p), bytes}, [&]
  {
    for(int row = 0; row < p.hessian.size(); ++row)
      Eigen::Map<Eigen::Matrix<NT, 3, 1> >(y.data() + 3 * std::size_t(row)) = p.hessian.multiply_row(row, x.data());
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  });
}

template <typename Kernel>
void add(const std::string& name, const Kernel& kernel)
{
  for(const int n : {20, 55}) // 48,000 cells and a million
    benchmark::RegisterBenchmark((name + "/cells:" + std::to_string(6 * n * n * n)).c_str(),
                                 [=](benchmark::State& state) { kernel(state, problem(n)); })
      ->Unit(benchmark::kMillisecond);
}

template <typename Energy>
void add_energy(const std::string& name, const Energy& energy)
{
  add("evaluate/" + name, [=](benchmark::State& state, Grid_problem& p) { evaluate(state, p, energy); });
  add("assemble_PSD/" + name, [=](benchmark::State& state, Grid_problem& p) { assemble(state, p, energy, 0.); });
  add("assemble_full/" + name, [=](benchmark::State& state, Grid_problem& p) { assemble(state, p, energy, 1.); });
}

int main(int argc, char* argv[])
{
  benchmark::Initialize(&argc, argv);
  if(benchmark::ReportUnrecognizedArguments(argc, argv))
    return EXIT_FAILURE;
  add("singular_values", singular_values);
  add_energy("stretch", Stretch_energy_3());
  add_energy("untangling", Untangling_energy_3(0.1, 0.01));
  add("largest_step", largest_step);
  add("matrix_product", matrix_product);
  benchmark::RunSpecifiedBenchmarks();
}
