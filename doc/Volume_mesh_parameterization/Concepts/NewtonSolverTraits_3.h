/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `NewtonSolverTraits_3` describes a solver for the sparse symmetric linear systems of Newton's
method. The unknowns are the coordinates of the free vertices. All systems of one stage of a parameterization have the
same pattern. Stages are: fixed boundary, soft boundary, sliding boundary vertices, and bound of angles. A refinement
begins a new stage. `analyze_pattern()` is called once at the beginning of a stage, then `factorize()` and `solve()` for
each system. Three properties distinguish the concept from `SparseLinearAlgebraWithFactorTraits_d`: the analysis of the
pattern, the matrix of 3x3 blocks, and the tolerance. Small systems of patches of the mesh may come in between. The
pattern of the stage is then analyzed again.

The matrix passed to `factorize()` keeps its address and its values until `solve()` has returned. Its size may be 0. The
thread that called the parameterization makes all calls.

A model that is passed by value must be copy constructible. A copy need not share the pattern or the factorization.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Volume_mesh_parameterization::Conjugate_gradient_solver_traits_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::CHOLMOD_solver_traits_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Eigen_solver_traits_3}
\cgalHasModelsEnd

\sa `CGAL::stretch_minimizing_volume_parameterization()`
*/
class NewtonSolverTraits_3
{
public:
  /// \name Types
  /// @{

  /// the number type of the matrix: `float` or `double`
  typedef unspecified_type NT;

  /// the type of the matrix
  typedef CGAL::Volume_mesh_parameterization::Block_sparse_matrix_3<NT> Matrix;

  /// @}

  /// \name Operations
  /// @{

  /// prepares for matrices with the pattern of `A`. The values of `A` are not used. A call for another pattern replaces this
  /// one. `factorize()` reports failures.
  void analyze_pattern(const Matrix& A);

  /// prepares for the solution of systems with the matrix `A`. Its pattern is the one analyzed.
  ///
  /// \return `SUCCESS`; or `NOT_POSITIVE_DEFINITE` if the matrix is not positive definite; or `OUT_OF_MEMORY` or `FAILED`.
  ///         After `NOT_POSITIVE_DEFINITE`, another matrix is tried. The last two end the computation.
  CGAL::Volume_mesh_parameterization::Linear_solver_status factorize(const Matrix& A);

  /// solves \f$A x = b\f$ for the matrix last passed to `factorize()`, perhaps several times. The vector `b` has three
  /// entries a row of blocks. The vector `x` has an arbitrary size on entry, and receives as many entries. An iterative solver
  /// may stop as soon as the residual, in a norm of its choice, is at most `tolerance` times its value for \f$x = 0\f$.
  ///
  /// \return one of the following. Only after the first three, `x` is used.
  ///         - `SUCCESS`;
  ///         - `ITERATION_LIMIT` if the solver stopped before, with an `x` with \f$b^T x > 0\f$, which is not used to decide
  ///           about convergence;
  ///         - `TRUNCATED` if the matrix is not positive definite, and `x` with \f$b^T x > 0\f$ is the best vector found before;
  ///         - `NOT_POSITIVE_DEFINITE` if there is no such `x`;
  ///         - `OUT_OF_MEMORY` or `FAILED`.
  CGAL::Volume_mesh_parameterization::Linear_solver_status
  solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, double tolerance);

  /// @}
};
