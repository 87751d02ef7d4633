// Times the kernels of the solver on one thread, beside the peaks of the machine that the same program measures.
#include "Counting_number.h"
#include "Grid_problem.h"
#include "machine_peak.h"

#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Distortion_derivatives_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Signed_singular_values_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Untangling_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Energy_sum_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/largest_step_3.h>
#include <CGAL/tags.h>

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

using Energy_sum = Energy_sum_3<CGAL::Sequential_tag>;
using Counted_matrix = Matrix_3<Counting_number>;

Grid_problem& problem(const std::size_t n)
{
  static std::map<std::size_t, Grid_problem> problems;
  return problems.try_emplace(n, n).first->second;
}

// What a call must compute, and what it must move if nothing stays in a cache between two passes.
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
    const Counted_matrix inverse_source = p.inverse_sources[c].cast<Counting_number>();
    int number_of_free_vertices = 0;
    for(const int v : cell)
      number_of_free_vertices += p.mesh.is_free(v);
    sum += count_operations([&]
    {
      Counted_matrix U;
      for(int k = 0; k < 3; ++k)
        for(int i = 0; i < 3; ++i)
          U(i, k) = Counting_number(p.u(i, cell[k + 1])) - Counting_number(p.u(i, cell[0]));
      f(Counted_matrix(U * inverse_source), inverse_source, number_of_free_vertices);
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

void singular_values(benchmark::State& state, Grid_problem& p)
{
  const double operations = count_cells(p, [](const Counted_matrix& J, const Counted_matrix&, int)
  {
    signed_singular_values_3(J);
  });
  measure(state, p, {operations, bytes_of_packs(p, geometry_bytes) + bytes_of_positions(p)}, [&]
  {
    Pack largest(0);
    for(std::size_t i = 0; i < p.packs.number_of_packs(); ++i)
    {
      const Matrix_3<Pack> J = edge_matrix(p.u, p.packs[i]) * p.packs[i].inverse_source;
      largest = maximum(largest, signed_singular_values_3(J).s[0]);
    }
    benchmark::DoNotOptimize(largest);
  });
}

template <typename Energy>
void evaluate(benchmark::State& state, Grid_problem& p, const Energy& energy)
{
  const double operations = count_cells(p, [&](const Counted_matrix& J, const Counted_matrix&, int)
  {
    const Vector_3<Counting_number> s = signed_singular_values_3(J).s;
    Counting_number sum = 0;
    sum += Counting_number(1) * energy.value(s) + s[0] * s[1] * s[2];
  });
  const double bytes = bytes_of_packs(p, geometry_bytes + sizeof(Cell_pack_3::weight)) + bytes_of_positions(p);
  const Energy_sum sum(p.packs);
  measure(state, p, {operations, bytes}, [&]
  {
    benchmark::DoNotOptimize(sum.evaluate(energy, p.u));
  });
}

template <typename Energy>
void assemble(benchmark::State& state, Grid_problem& p, const Energy& energy, const double negative_curvature)
{
  const double operations = count_cells(p, [&](const Counted_matrix& J, const Counted_matrix& inverse_source, int m)
  {
    Cell_derivatives_3<Counting_number> cell;
    cell_derivatives_3(distortion_derivatives_3<Counting_number>(energy, J, negative_curvature),
                       inverse_source, Counting_number(1), cell);
    Counting_number::count() += 3 * m + 9 * m * (m + 1) / 2; // additions to the gradient and to the Hessian
  });
  // gradient: cleared and updated; Hessian: cleared, one half updated and copied to the other
  const double bytes = bytes_of_packs(p, sizeof(Cell_pack_3)) + bytes_of_positions(p)
                     + 3. * sizeof(double) * static_cast<double>(p.gradient.size())
                     + number_of_blocks(p) * (3. * 9 * sizeof(Grid_problem::Matrix::NT) + sizeof(int));
  const Energy_sum sum(p.packs);
  measure(state, p, {operations, bytes}, [&]
  {
    sum.assemble(energy, p.u, negative_curvature, p.gradient, p.hessian);
    benchmark::ClobberMemory();
  });
}

void largest_step(benchmark::State& state, Grid_problem& p)
{
  const double operations = count_cells(p, [](const Counted_matrix& J, const Counted_matrix& inverse_source, int)
  {
    const Counted_matrix dJ = J * inverse_source; // as many operations as for J itself
    determinant_polynomial<Counting_number>(J, dJ);
  });
  const Eigen::Matrix3Xd direction = 0.1 * p.u;
  measure(state, p, {operations, bytes_of_packs(p, geometry_bytes) + 2 * bytes_of_positions(p)}, [&]
  {
    benchmark::DoNotOptimize(largest_step_3<CGAL::Sequential_tag>(p.packs, p.u, direction));
  });
}

void matrix_product(benchmark::State& state, Grid_problem& p)
{
  using NT = Grid_problem::Matrix::NT;
  Energy_sum(p.packs).assemble(Stretch_energy_3(), p.u, 0., p.gradient, p.hessian);
  const std::size_t n = 3 * static_cast<std::size_t>(p.hessian.size());
  std::vector<NT> x(n + 1, NT(1)), y(n);
  const double bytes = number_of_blocks(p) * (9. * sizeof(NT) + sizeof(int)) + 2. * sizeof(NT) * static_cast<double>(n);
  measure(state, p, {18 * number_of_blocks(p), bytes}, [&]
  {
    for(int row = 0; row < p.hessian.size(); ++row)
      Eigen::Map<Vector_3<NT> >(y.data() + 3 * std::size_t(row)) = p.hessian.multiply_row(row, x.data());
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
