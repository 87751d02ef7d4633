/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `NewtonSolverTraits_3` describes a solver for the sparse symmetric linear systems of Newton's
method, whose unknowns are the coordinates of the free vertices. All systems of one stage of a
parameterization (fixed boundary, soft boundary, boundary vertices that slide, bound of angles, each again after a
refinement) have the same pattern. So the work that depends on the pattern only is done once: `analyze_pattern()` is
called at the beginning of a stage, then `factorize()` and `solve()` for each system. This distinguishes the concept
from `SparseLinearAlgebraWithFactorTraits_d`, as do the matrix of 3x3 blocks and the tolerance. Small systems, of patches
of the mesh, may come in between; then the pattern of the stage is analyzed again.

The matrix passed to `factorize()` keeps its place and its values until `solve()` has returned. It may have the size
0. All calls are made by the thread that called the parameterization.

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

  /// prepares for matrices with the pattern of `A`. The values of `A` are not used. It is called again for another
  /// pattern, which replaces this one. Failures are told by `factorize()`.
  void analyze_pattern(const Matrix& A);

  /// prepares for the solution of systems with the matrix `A`, whose pattern is the one analyzed.
  ///
  /// \return `SUCCESS`; or `NOT_POSITIVE_DEFINITE` if the matrix turns out not to be positive definite, after which
  ///         another matrix will be tried; or `OUT_OF_MEMORY` or `FAILED`, which end the computation
  CGAL::Volume_mesh_parameterization::Linear_solver_status factorize(const Matrix& A);

  /// solves \f$A x = b\f$ for the matrix last passed to `factorize()`, perhaps several times, where `b` has three
  /// entries a row of blocks, and `x`, whose size on entry is arbitrary, receives as many. An iterative solver may stop
  /// as soon as the residual, in a norm of its choice, has fallen to `tolerance` times its value for \f$x = 0\f$.
  ///
  /// \return `SUCCESS`; or `ITERATION_LIMIT` if the solver gave up before, with an `x` with \f$b^T x > 0\f$, by which
  ///         convergence is not judged; or `TRUNCATED` if the matrix is not positive definite, but `x` with
  ///         \f$b^T x > 0\f$ is the best one before this was noticed; or `NOT_POSITIVE_DEFINITE` if there
  ///         is none; or `OUT_OF_MEMORY` or `FAILED`. Only after the first three `x` is used.
  CGAL::Volume_mesh_parameterization::Linear_solver_status
  solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, double tolerance);

  /// @}
};
