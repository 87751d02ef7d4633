/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `ParameterizationVisitor_3` describes an object that receives the progress of
`CGAL::stretch_minimizing_volume_parameterization()`, and may end the computation. Uses are a progress bar, a plot of the
convergence, or a button that stops the computation. Pass a visitor that collects data by `std::ref()`. If a visitor is
passed by value, the function uses a copy, and models must be copy constructible.

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

  /// is called after each step of Newton's method or of a patch, by the thread that called the function. It is also called at the
  /// beginning of each round of a loop over the boundary or over hexahedra (see `Parameterization_step::kind`). Exceptions pass
  /// through, and no image is then written.
  ///
  /// \return `false` to end the computation with the status `ERROR_INTERRUPTED`. The current map is written if no cell is
  ///         inverted. In `Phase::SPLITS`, only this phase ends, and the map to the boundary so far is found.
  ///
  /// The call should take little time compared with a step, which is linear in the number of cells.
  bool after_step(const CGAL::Volume_mesh_parameterization::Parameterization_step& step);

  /// returns whether the computation may continue. The same thread calls it many times between two steps. Functions without such
  /// steps call it, too. This function is optional. Without it, only `after_step()` and time limits end a computation.
  ///
  /// \return `false` to end the computation as `after_step()` does
  ///
  /// The function should only read a variable.
  bool goes_on();

  /// @}
};
