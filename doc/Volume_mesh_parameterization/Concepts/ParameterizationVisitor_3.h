/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `ParameterizationVisitor_3` describes an object that is told of the progress of
`CGAL::stretch_minimizing_volume_parameterization()`, and may end it: for a progress bar, a plot of the
convergence, or a button that stops the computation. A visitor that collects data is passed by `std::ref()`; of what is
passed by value a copy is used, so models must then be copy constructible.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Volume_mesh_parameterization::Default_visitor}
\cgalHasModelsEnd

\sa `CGAL::stretch_minimizing_volume_parameterization()`
*/
class ParameterizationVisitor_3
{
public:
  /// \name Operations
  /// @{

  /// is called after each step, of Newton's method or of a patch, and where a round begins of a loop over the boundary or over
  /// hexahedra (see `Parameterization_step::kind`), by the thread that called the function. Exceptions pass through; no image
  /// is then written.
  ///
  /// \return `false` to end the computation, which then has the status `ERROR_INTERRUPTED`. The map reached so far
  ///         is written if no cell is inverted.
  ///
  /// It should take little time compared with a step, which is linear in the number of cells.
  bool after_step(const CGAL::Volume_mesh_parameterization::Parameterization_step& step);

  /// may the computation go on? Asked many times between two steps, by the same thread, and by those functions that take
  /// no such steps. This function is optional; without it, only `after_step()` and limits of time end a computation.
  ///
  /// \return `false` to end the computation as `after_step()` does
  ///
  /// It should do no more than to look at a variable.
  bool goes_on();

  /// @}
};
