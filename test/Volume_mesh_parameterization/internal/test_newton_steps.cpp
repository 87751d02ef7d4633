// Newton's method on plain arrays: sums over the cells, step lengths, the harmonic map, and systems of some unknowns.
#include "catch.h"
#include "map_checks.h"

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/harmonic_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/minimize_energy_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

namespace {

// The parts of the engine on a mesh with X^{-1} as it is.
struct Parts
{
  VMP::internal::Unknowns_3 unknowns;
  VMP::internal::Sparsity_pattern_3 pattern;
  VMP::internal::Scaled_cells_3 scaled;
  VMP::internal::Cell_packs_3 packs;
  VMP::Block_sparse_matrix_3<double> hessian;

  explicit Parts(const Numbered_mesh_3& mesh)
    : unknowns(free_vertices(mesh)), pattern(sparsity_pattern_3(mesh, unknowns)),
      scaled{1, inverse_sources(mesh), make_weights(mesh)}, packs(mesh, scaled, unknowns, pattern)
  {
    hessian.set_pattern(pattern.row_begin, pattern.columns);
  }

  static std::vector<double> make_weights(const Numbered_mesh_3& mesh)
  {
    std::vector<double> weights(mesh.cells.size());
    std::iota(weights.begin(), weights.end(), 1.);
    return weights;
  }

  template <typename Energy>
  VMP::internal::Energy_evaluation evaluate(const Energy& energy, const Matrix3Xd& u) const
  {
    return evaluate_energy(packs, VMP::internal::Cell_energy_of<Energy>(energy), u);
  }
};

} // namespace

TEMPLATE_TEST_CASE("The sum over the cells has the value and the derivatives it should", "",
                   VMP::Stretch_energy_3, VMP::Dirichlet_energy_3)
{
  const Numbered_mesh_3 mesh = cube_mesh(3, 0.1);
  const Matrix3Xd u = mesh.source + noise(mesh.number_of_vertices(), 0.1);
  const TestType energy;
  Parts parts(mesh);

  double expected = 0;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    if(*std::min_element(mesh.cells[c].begin(), mesh.cells[c].end()) < mesh.number_of_free_vertices)
      expected += parts.scaled.weights[c] * psi(energy, mesh, u, mesh.cells[c]);
  const VMP::internal::Energy_evaluation evaluation = parts.evaluate(energy, u);
  CHECK(evaluation.energy == Approx(expected).epsilon(1e-12));
  CHECK(evaluation.is_flip_free());

  const VMP::internal::Cell_energy_of<TestType> cell_energy(energy);
  const auto assembled_gradient = [&](const Matrix3Xd& v)
  {
    Matrix3Xd gradient;
    assemble_energy(parts.packs, cell_energy, v, 1., gradient, parts.hessian);
    return gradient;
  };
  const double h = 1e-5;
  const Matrix3Xd gradient = assembled_gradient(u);
  Matrix3Xd gradient_alone = Matrix3Xd::Zero(3, mesh.number_of_free_vertices);
  add_energy_gradient(parts.packs, cell_energy, u, gradient_alone);
  CHECK((gradient_alone - gradient).norm() <= 1e-12 * gradient.norm());
  const VMP::Block_sparse_matrix_3<double> hessian = parts.hessian;
  for(int i = 0; i < 3 * mesh.number_of_free_vertices; ++i)
  {
    Matrix3Xd forward = u, backward = u;
    forward(i) += h;
    backward(i) -= h;
    const double difference
      = (parts.evaluate(energy, forward).energy - parts.evaluate(energy, backward).energy) / (2 * h);
    CHECK(gradient(i) == Approx(difference).margin(1e-7 * gradient.norm()));

    const Matrix3Xd differences = (assembled_gradient(forward) - assembled_gradient(backward)) / (2 * h);
    Matrix3Xd column = Matrix3Xd::Zero(3, mesh.number_of_free_vertices);
    for(int k = hessian.row_begin(i / 3); k < hessian.row_end(i / 3); ++k)
      column.col(hessian.column(k)) = hessian.block(k).row(i % 3).transpose();
    CHECK((column - differences).norm() <= 1e-6 * column.norm());
  }
}

TEST_CASE("Inverted cells are counted")
{
  const Numbered_mesh_3 mesh = cube_mesh(4);
  const Parts parts(mesh);
  Matrix3Xd u = mesh.source;
  CHECK(parts.evaluate(VMP::Dirichlet_energy_3(), u).number_of_inverted_cells == 0);
  u.col(0) += Vector3d(0, 0, 1.5);
  const std::size_t expected = number_of_inverted_cells(mesh, u);
  CHECK(expected > 0);
  CHECK(parts.evaluate(VMP::Dirichlet_energy_3(), u).number_of_inverted_cells == expected);
  CHECK(parts.evaluate(VMP::Dirichlet_energy_3(), u).smallest_determinant == Approx(-0.5));
}

TEST_CASE("The largest step is the first root of a determinant")
{
  const Numbered_mesh_3 mesh = cube_mesh(3);
  const Parts parts(mesh);
  for(const double amplitude : {0.01, 0.3, 1., 3., 100.})
    for(const unsigned int seed : {1, 2, 3})
    {
      Matrix3Xd d = noise(mesh.number_of_vertices(), amplitude, seed);
      d.rightCols(mesh.number_of_vertices() - mesh.number_of_free_vertices).setZero();

      double root = 1; // the first of many samples with an inverted cell
      constexpr int samples = 20000;
      for(const std::array<int, 4>& cell : mesh.cells)
      {
        const Matrix3d X = VMP::internal::edge_matrix(mesh.source, cell), D = VMP::internal::edge_matrix(d, cell);
        const double c = (X.inverse() * D).cwiseAbs().rowwise().sum().maxCoeff(); // no root is below 1 / c
        for(int i = static_cast<int>(samples / (std::max)(1., c)); i < root * samples; ++i)
          if(!((X + (double(i) / samples) * D).determinant() > 0))
            root = double(i) / samples;
      }

      const double step = VMP::internal::largest_step_3(parts.packs, mesh.source, d);
      INFO("amplitude " << amplitude << ", first root about " << root);
      CHECK(step <= root);
      CHECK(step >= root - 1. / 1024 - 1. / samples);
    }
}

TEST_CASE("A step is not doubled where a cell is turned over on the way")
{
  // half a turn of two vertices about the other two, on lines that just miss the axis
  Numbered_mesh_3 mesh;
  mesh.source.resize(3, 4);
  mesh.source << 1, 0, 0, 0,
                 0, 1, 0, 0,
                 0, 0, 0, 1;
  mesh.target = mesh.source;
  mesh.cells = { {2, 3, 0, 1} };
  mesh.number_of_free_vertices = 2;
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  const VMP::internal::Scaled_cells_3 scaled{1, inverse_sources(mesh), {1.}};
  const VMP::internal::Newton_system_3 system(mesh, scaled, free_vertices(mesh), linear_solver);
  const VMP::Stretch_energy_3 stretch;
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy(stretch);

  const auto length_after = [&](const Vector3d& c, const Vector3d& d)
  {
    VMP::internal::Newton_iterate_3 iterate{ 1, mesh.source };
    iterate.direction.vectors = Matrix3Xd::Zero(3, 4);
    iterate.direction.vectors.leftCols(2) << c, d;
    const Matrix3Xd step = 0.4 * iterate.direction.vectors, u = mesh.source + step, doubled = u + step;
    REQUIRE(system.evaluate(energy, u).is_flip_free());
    REQUIRE(system.evaluate(energy, doubled).is_flip_free());
    REQUIRE(system.evaluate(energy, doubled).energy < system.evaluate(energy, u).energy);
    return extrapolated(system, energy, iterate, {0.4, u, system.evaluate(energy, u)}).length;
  };
  CHECK(length_after(Vector3d(-2, 0.1, 0), Vector3d(0.1, -2, 0)) == 0.4);  // the determinant is negative halfway
  CHECK(length_after(Vector3d(-2, 0.1, 0), Vector3d(-0.1, -2, 0)) > 0.4);  // and here it is not
}

namespace {

struct Counting_solver : Solver<>
{
  int number_of_factorizations = 0;

  VMP::Linear_solver_status factorize(const Matrix& A)
  {
    ++number_of_factorizations;
    return Solver<>::factorize(A);
  }
};

// Computes the harmonic map by linear finite elements, each with the same weight, and a dense factorization.
Matrix3Xd harmonic_map(const Numbered_mesh_3& mesh)
{
  const int n = mesh.number_of_vertices(), free = mesh.number_of_free_vertices;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for(const std::array<int, 4>& cell : mesh.cells)
  {
    Eigen::Matrix<double, 3, 4> gradients; // gradients of the barycentric coordinates
    gradients.rightCols(3) = Matrix3d(VMP::internal::edge_matrix(mesh.source, cell)).inverse().transpose();
    gradients.col(0) = -gradients.rightCols(3).rowwise().sum();
    const Eigen::Matrix4d products = gradients.transpose() * gradients;
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 4; ++j)
        stiffness(cell[i], cell[j]) += products(i, j);
  }
  Matrix3Xd result = mesh.target;
  const Eigen::MatrixXd right = -stiffness.topRightCorner(free, n - free) * mesh.target.rightCols(n - free).transpose();
  result.leftCols(free) = stiffness.topLeftCorner(free, free).ldlt().solve(right).transpose();
  return result;
}

} // namespace

TEST_CASE("The harmonic map is that of a dense solution, by one matrix and steps that are not exact")
{
  for(const Numbered_mesh_3& mesh : { ring(6), twisted_cube(4, 0.2) })
  {
    Counting_solver solver;
    fixed_boundary::Problem<VMP::Stretch_energy_3, Counting_solver> problem(mesh, VMP::Stretch_energy_3(), solver);
    const Matrix3Xd map = fixed_boundary::harmonic_start(mesh, problem.system);
    CHECK((map - harmonic_map(mesh)).norm() < 1e-6 * mesh.target.norm());
    CHECK(solver.number_of_factorizations == 1);
    CHECK(problem.solver.number_of_iterations() > std::size_t(solver.number_of_iterations()));
  }
}

TEST_CASE("The reference cells of a system can be exchanged")
{
  const Numbered_mesh_3 mesh = twisted_cube(3, 0.15);
  const VMP::Stretch_energy_3 stretch;
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy(stretch);
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  const VMP::internal::Scaled_cells_3 source = cells_scaled_to_target(mesh), regular = regular_cells_scaled_to_target(mesh);
  CHECK(source.scale == regular.scale);
  VMP::internal::Newton_system_3 exchanged(mesh, source, free_vertices(mesh), linear_solver);
  exchanged.set_references(VMP::internal::Reference_cells::REGULAR);
  const VMP::internal::Newton_system_3 system(mesh, regular, free_vertices(mesh), linear_solver);
  const Matrix3Xd u = source.scale * mesh.source;
  CHECK(exchanged.evaluate(energy, u).energy == system.evaluate(energy, u).energy);
  exchanged.set_references(VMP::internal::Reference_cells::SOURCE);
  CHECK(exchanged.evaluate(energy, u).energy != system.evaluate(energy, u).energy);
  // all edges of a regular cell are equally long, and all cells together fill the target
  const Eigen::Matrix3d edges = regular.inverse_sources[0].inverse();
  for(int i = 0; i < 3; ++i)
  {
    CHECK(edges.col(i).norm() == Approx(edges.col(0).norm()));
    CHECK((edges.col(i) - edges.col((i + 1) % 3)).norm() == Approx(edges.col(0).norm()));
  }
  CHECK(edges.determinant() / 6 * mesh.cells.size()
        == Approx(std::pow(regular.scale, 3) * VMP::internal::volume(mesh, mesh.target)));
}

TEST_CASE("A system of some of the unknowns is a part of that of all")
{
  const Numbered_mesh_3 mesh = cube_mesh(5, 0.15);
  const VMP::Stretch_energy_3 stretch;
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy(stretch);
  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double> solver;
  VMP::internal::Linear_solver_of linear_solver(solver);
  const VMP::internal::Newton_system_3 whole(mesh, free_vertices(mesh), linear_solver);
  VMP::internal::Newton_system_3 part(whole, whole.unknowns().without([](const int v) { return v % 3 == 0; }), linear_solver);
  const auto& some = part.unknowns();
  REQUIRE(some.size() > 20);
  Matrix3Xd u = whole.scale() * mesh.source;
  u.leftCols(mesh.number_of_free_vertices) += noise(mesh.number_of_free_vertices, 0.02);
  REQUIRE(whole.evaluate(energy, u).is_flip_free());

  // the gradient of the whole, by the unknowns of the part
  const auto gradient = [&](const Matrix3Xd& positions)
  {
    const Matrix3Xd of_all = whole.gradient(energy, positions);
    Eigen::VectorXd result(3 * some.size());
    for(int row = 0; row < some.size(); ++row)
      result.segment<3>(3 * row) = Vector3d(of_all.col(whole.unknowns().row(some.vertex(row))));
    return result;
  };
  const Matrix3Xd own = part.gradient(energy, u);
  CHECK((Eigen::Map<const Eigen::VectorXd>(own.data(), own.size()) - gradient(u)).norm() < 1e-12 * own.norm());

  // its Newton direction, by differences of that gradient
  constexpr double h = 1e-6;
  Eigen::MatrixXd H(3 * some.size(), 3 * some.size());
  for(int k = 0; k < H.cols(); ++k)
  {
    Matrix3Xd above = u, below = u;
    above(k % 3, some.vertex(k / 3)) += h;
    below(k % 3, some.vertex(k / 3)) -= h;
    H.col(k) = (gradient(above) - gradient(below)) / (2 * h);
  }
  const Eigen::VectorXd expected = H.fullPivLu().solve(-gradient(u));
  const auto direction = part.direction(energy, u, 1, 1e-10);
  REQUIRE(direction.status == VMP::Linear_solver_status::SUCCESS);
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(some.contains(v))
      CHECK((direction.vectors.col(v) - expected.segment<3>(3 * some.row(v))).norm() < 1e-5 * expected.norm());
    else
      CHECK(direction.vectors.col(v) == Vector3d::Zero());
  CHECK(direction.slopes.sum() == Approx(direction.slope));
  CHECK(direction.slope == Approx(gradient(u).dot(expected)).epsilon(1e-5));
}

TEST_CASE("A cell that is nearly flat takes steps of a few vertices, and hardly any of all")
{
  const Numbered_mesh_3 mesh = cube_mesh(10);
  const auto [v, far] = middle_and_corner(mesh);
  // the free vertex v moves until it is 1e-9 away from the plane of a facet opposite to it
  const auto flat_cell = std::find_if(mesh.cells.begin(), mesh.cells.end(), [v = v](const std::array<int, 4>& cell)
  { return std::count(cell.begin(), cell.end(), v) > 0; });
  Vector3d center = Vector3d::Zero();
  for(const int w : *flat_cell)
    if(w != v)
      center += Vector3d(mesh.source.col(w) / 3);
  Matrix3Xd start = mesh.source;
  start.col(v) = center + 1e-9 * (mesh.source.col(v) - center);
  REQUIRE(number_of_inverted_cells(mesh, start) == 0);

  const VMP::Stretch_energy_3 stretch;
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy(stretch);
  Solver<> solver;
  VMP::internal::Linear_solver_of linear_solver(solver);
  VMP::internal::Newton_system_3 system(mesh, free_vertices(mesh), linear_solver);
  VMP::internal::Progress_3 progress = patient_progress();
  const auto result = minimize_energy_3(system, energy, start, progress);
  CHECK(result.status == VMP::OK);
  CHECK((result.positions - mesh.source).colwise().norm().maxCoeff() < 1e-5);
  // the height of the cell grows by a factor in each step, and of all vertices 34 are needed
  CHECK(progress.number_of_steps() < 20);
}

TEST_CASE("The energy of a step counts the cells without a free vertex")
{
  const Numbered_mesh_3 mesh = twisted_cube(4);
  const auto is_prescribed = [&](const std::array<int, 4>& cell)
  {
    return std::none_of(cell.begin(), cell.end(), [&](const int v) { return mesh.is_free(v); });
  };
  REQUIRE(std::count_if(mesh.cells.begin(), mesh.cells.end(), is_prescribed) > 10);
  const VMP::Stretch_energy_3 energy;
  const Outcome outcome = run(mesh);
  REQUIRE(outcome.status == VMP::OK);
  CHECK(outcome.energy == Approx(mean_energy(energy, mesh, outcome.positions)).epsilon(1e-10));
  const double factor = std::cbrt(VMP::internal::volume(mesh, mesh.source)
                                  / VMP::internal::volume(mesh, outcome.positions));
  const double energy_of_result
    = VMP::internal::mean_energy_3(mesh, VMP::internal::singular_values_of_cells_3(mesh, outcome.positions),
                                   VMP::internal::Cell_energy_of<VMP::Stretch_energy_3>(energy), factor);
  CHECK(outcome.energy == Approx(energy_of_result).epsilon(1e-10));
}

TEST_CASE("Steps of vertices in planes and on lines stay there, and solve the projected system")
{
  Numbered_mesh_3 mesh = cube_mesh(3, 0.1);
  const Matrix3Xd directions = noise(mesh.number_of_prescribed_vertices(), 1, 7);
  for(int i = 0; i < mesh.number_of_prescribed_vertices(); ++i)
  {
    using Condition = VMP::Vertex_condition_3;
    const Vector3d n = directions.col(i);
    mesh.conditions.push_back(i % 3 == 0 ? Condition::at_target() : i % 3 == 1 ? Condition::on_line(n[0], n[1], n[2])
                                                                              : Condition::in_plane(n[0], n[1], n[2]));
  }
  Solver<> traits;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(traits);
  VMP::internal::Newton_system_3 system(mesh, free_vertices(mesh), linear_solver);
  const VMP::Symmetric_Dirichlet_energy_3 symmetric;
  const VMP::internal::Cell_energy_of<VMP::Symmetric_Dirichlet_energy_3> energy(symmetric);
  const Matrix3Xd u = system.scale() * (mesh.source + noise(mesh.number_of_vertices(), 0.03));
  const VMP::internal::Newton_direction_3 direction = system.direction(energy, u, 1., 1e-6);
  REQUIRE(direction.is_exact());

  // in the admissible directions, the gradient is the derivative of the energy, and changes along the step by its negative
  const auto derivative = [&](const Matrix3Xd& at, const int v, const Vector3d& along)
  {
    constexpr double h = 1e-5;
    Matrix3Xd plus = at, minus = at;
    plus.col(v) += h * along;
    minus.col(v) -= h * along;
    return (system.evaluate(energy, plus).energy - system.evaluate(energy, minus).energy) / (2 * h);
  };
  constexpr double t = 1e-3;
  const Matrix3Xd ahead = u + t * direction.vectors, behind = u - t * direction.vectors, gradient = system.gradient(energy, u);
  const double size = gradient.cwiseAbs().maxCoeff();
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const Matrix3d P = mesh.projector(v);
    CHECK((direction.vectors.col(v) - P * Vector3d(direction.vectors.col(v))).norm() < 1e-12);
    CHECK(system.unknowns().contains(v) == !mesh.is_fixed(v));
    if(mesh.is_fixed(v))
      continue;
    const int row = system.unknowns().row(v);
    for(int i = 0; i < 3; ++i)
    {
      const Vector3d along = P.col(i);
      CHECK(gradient(i, row) == Approx(derivative(u, v, along)).margin(1e-6 * size));
      const double change = (derivative(ahead, v, along) - derivative(behind, v, along)) / (2 * t);
      CHECK(change == Approx(-gradient(i, row)).margin(1e-3 * size));
    }
  }
}
