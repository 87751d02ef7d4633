/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `ParameterizationVisitor_3` describes an object that is told of the progress of
`CGAL::stretch_minimizing_volume_parameterization()`, and may end it: for a progress bar, a plot of the
convergence, or a button that stops the computation. A visitor that collects data is passed by `std::ref()`.

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

  /// is called after each Newton step, by the thread that called the parameterization.
  /// Exceptions pass through; the result is then left alone.
  ///
  /// \return `false` to end the computation. The map reached so far is returned if no cell is inverted.
  bool after_step(const CGAL::Volume_mesh_parameterization::Parameterization_step& step);

  /// @}
};
