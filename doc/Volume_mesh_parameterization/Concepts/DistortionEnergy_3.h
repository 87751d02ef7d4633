/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `DistortionEnergy_3` describes what is minimized by
`CGAL::stretch_minimizing_volume_parameterization()`: the mean, over the cells of the complex, of a
function \f$\psi(\sigma_1, \sigma_2, \sigma_3)\f$ of the signed singular values of the differential
\f$J\f$ of the map in a cell.

The signed singular values are those of \f$J = R\,\mathrm{diag}(\sigma_1, \sigma_2, \sigma_3)\,Q^T\f$ with
two rotations \f$R\f$ and \f$Q\f$, and \f$\sigma_1 \ge \sigma_2 \ge |\sigma_3|\f$. Their product is
\f$\det J\f$, the change of the volume; an inverted cell is one with \f$\sigma_3 < 0\f$. Before \f$J\f$ is
computed, the source is scaled to the volume of the target, so that 1 stands for the mean change of lengths. The
values have no unit.

The function must be symmetric: no permutation of its arguments changes its value. It must be twice
continuously differentiable where all arguments are positive, also where some of them are equal; then
it is so as a function of the matrix \f$J\f$. A maximum of the arguments, for example, is not allowed, but a
sum of high powers is. It need not be convex.

All functions are templates of a number type `T`, which is `double`, or a type for several cells at
a time that is evaluated with the vector instructions of the processor. This type has the arithmetic
operators, it can be constructed from `double`, and `sqrt`, `abs`, `exp` and `log` are found by
argument-dependent lookup. So write `T(2)` instead of `2`, say `using std::sqrt;` and call `sqrt(x)`. Do not branch on
values of type `T`: comparisons with `<`, `<=`, `>` and `>=` hold a result for each cell, to be passed to
`CGAL::Volume_mesh_parameterization::select()`; beside it, there are `minimum()` and `maximum()`, of the header
`CGAL/Volume_mesh_parameterization/select.h`. Say `using CGAL::Volume_mesh_parameterization::select;` and call
`select(x < T(0), a, b)`. Functions must not have side effects: they are called from
several threads.

An evaluation should take constant time: all three functions are called for each cell in each Newton step. Models must
be copy constructible; objects are copied, and should be small.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Volume_mesh_parameterization::Stretch_energy_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Lp_stretch_energy_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Dirichlet_energy_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Symmetric_Dirichlet_energy_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::ARAP_energy_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::LSCM_energy_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::LPM_energy_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::MIPS_energy_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Barrier_energy_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Power_energy_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Bounded_angle_energy_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Any_energy_3}
\cgalHasModelsEnd

\sa `CGAL::stretch_minimizing_volume_parameterization()`
*/
class DistortionEnergy_3
{
public:
  /// \name Operations
  /// The vector `s` holds \f$\sigma_1, \sigma_2, \sigma_3\f$. For \f$\sigma_1\sigma_2\sigma_3 \le 0\f$ nothing is
  /// required of the results: no such map is accepted, whatever its energy. Unless \f$\psi\f$ tends to infinity where a
  /// cell becomes flat (\f$\sigma_3\f$ tends to 0 and \f$\sigma_1\f$ does not), cells become flat during the minimization
  /// and keep it from going on; `Barrier_energy_3` adds such a barrier.
  /// @{

  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const;

  /// returns the three first derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const;

  /// returns the symmetric matrix of the second derivatives
  /// \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const;

  /// @}

  /// \name Optional
  /// @{

  /// returns \f$\psi\f$ of \f$|J|^2 = \sum_i\sigma_i^2\f$, \f$|J^{-1}|^2 = \sum_i\sigma_i^{-2}\f$ and \f$\det J\f$, where it
  /// depends on nothing else. The energy after a step is then found without the singular values, in a fraction of the time.
  template <typename T>
  T value_of_norms(const T& squared_norm, const T& squared_norm_of_inverse, const T& determinant) const;

  /// @}
};
