/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `DistortionEnergy_3` describes the energy of a cell. It is a function \f$\psi(\sigma_1, \sigma_2, \sigma_3)\f$ of the
signed singular values of the differential \f$J\f$ of the map. `CGAL::stretch_minimizing_volume_parameterization()` minimizes
the mean of \f$\psi\f$ over the cells of the complex.

The signed singular values are those of \f$J = R\,\mathrm{diag}(\sigma_1, \sigma_2, \sigma_3)\,Q^T\f$ with
two rotations \f$R\f$ and \f$Q\f$, and \f$\sigma_1 \ge \sigma_2 \ge |\sigma_3|\f$. Their product
\f$\det J\f$ is the change of the volume. A cell with \f$\sigma_3 < 0\f$ is inverted. Before \f$J\f$ is
computed, the source is scaled to the volume of the target. The value 1 is then the mean change of lengths.
The values have no unit.

The function must be symmetric: no permutation of its arguments changes its value. For positive
arguments, it must be twice continuously differentiable, also if some of them are equal. It is then twice
continuously differentiable as a function of the matrix \f$J\f$. A maximum of the arguments, for example, is not
allowed, but a sum of high powers is. The function need not be convex.

All functions are templates of a number type `T`. It is `double`, or a type for several cells at a time that uses
the vector instructions of the processor. This type has the arithmetic operators, and is constructible from
`double`. Argument-dependent lookup finds `sqrt`, `abs`, `exp` and `log`. Therefore, write `T(2)` instead of `2`,
and `using std::sqrt;` before `sqrt(x)`.

Do not branch on values of type `T`. Comparisons with `<`, `<=`, `>` and `>=` have a result for each cell, and
`CGAL::Volume_mesh_parameterization::select()` takes this result. Write
`using CGAL::Volume_mesh_parameterization::select;` and call `select(x < T(0), a, b)`. The header
`CGAL/Volume_mesh_parameterization/select.h` also has `minimum()` and `maximum()`. Several threads call the
functions. Therefore, they must not have side effects.

If a part of the boundary is free, the function needs a minimum. Consider similar cells,
\f$\psi(t\sigma_1, t\sigma_2, t\sigma_3)\f$ for \f$t > 0\f$: the lowest value must not belong to \f$t \to 0\f$ or \f$t \to \infty\f$
alone. The function for maps evaluates such cells, and refuses an energy without a minimum. `Stretch_energy_3` and
`Lp_stretch_energy_3` fall as cells grow. `Dirichlet_energy_3` and `LSCM_energy_3` fall as cells shrink.
`Symmetric_Dirichlet_energy_3`, `ARAP_energy_3`, `LPM_energy_3` and `MIPS_energy_3` have a minimum.

An evaluation should take constant time, because all three functions are called for each cell in each Newton step.
Models must be copy constructible. Objects are copied, and should be small.

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
  /// The vector `s` holds \f$\sigma_1, \sigma_2, \sigma_3\f$. For \f$\sigma_1\sigma_2\sigma_3 \le 0\f$, the results are arbitrary,
  /// because no such map is accepted. The function \f$\psi\f$ should tend to infinity if a cell becomes flat (\f$\sigma_3\f$ tends
  /// to 0 and \f$\sigma_1\f$ does not). Otherwise, cells become flat during the minimization, and stop it. `Barrier_energy_3` adds
  /// such a barrier.
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

  /// returns \f$\psi\f$ as a function of \f$|J|^2 = \sum_i\sigma_i^2\f$, \f$|J^{-1}|^2 = \sum_i\sigma_i^{-2}\f$ and
  /// \f$\det J\f$, if it depends on nothing else. The energy after a step then needs no singular values, and takes a
  /// fraction of the time.
  template <typename T>
  T value_of_norms(const T& squared_norm, const T& squared_norm_of_inverse, const T& determinant) const;

  /// @}
};
