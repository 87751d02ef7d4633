/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `BoundaryParameterizer_3` describes classes that find the images of the boundary vertices of a complex. A model is
passed as `boundary_parameterizer` to `CGAL::stretch_minimizing_volume_parameterization()`, which calls the function for arrays.
A class without it can be passed for complexes; then the function for complexes is called. Or the user calls `parameterize()`
first, and passes the images as `boundary_map`. This is necessary for corners, labels and landmarks.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Volume_mesh_parameterization::Ball_boundary_parameterizer_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Cube_boundary_parameterizer_3}
\cgalHasModels{CGAL::Polycube_meshing_3::Polycube_boundary_parameterizer_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Surface_boundary_parameterizer_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Surface_fit_boundary_parameterizer_3}
\cgalHasModelsEnd

\sa `CGAL::stretch_minimizing_volume_parameterization()`
*/
class BoundaryParameterizer_3
{
public:
/// \name Operations
/// @{

/*!
writes the image of each boundary vertex. A boundary facet has a cell of the complex on one side only.

The images of the facets form a closed surface without self-intersections, with the orientation of the boundary. A model may leave
this to the caller, as `CGAL::Volume_mesh_parameterization::Surface_boundary_parameterizer_3` does.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`
\tparam VertexPointMap a model of `WritablePropertyMap` with `C3t3::Vertex_handle` as key type and
        `C3t3::Triangulation::Geom_traits::Point_3` as value type

\param c3t3 the complex
\param target receives the images; the property map of `CGAL::Volume_mesh_parameterization::make_vertex_point_map()`
       can be passed as `boundary_map` afterwards
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{a limit for the running time in seconds}
    \cgalParamType{`double`}
    \cgalParamDefault{no limit}
    \cgalParamPrecondition{The value is a number, and not negative.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{an object that receives each round (`Step_kind::ROUND`), and may end the computation}
    \cgalParamType{a model of `ParameterizationVisitor_3`, passed by `std::ref()` if it keeps a state of interest}
    \cgalParamDefault{`CGAL::Volume_mesh_parameterization::Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK`, or an error code; then nothing is written. The code names the fault of the boundary. If the visitor or the time
        limit ended the computation, it is `ERROR_INTERRUPTED`.
*/
template <typename C3t3, typename VertexPointMap, typename NamedParameters = CGAL::parameters::Default_named_parameters>
CGAL::Volume_mesh_parameterization::Error_code
parameterize(const C3t3& c3t3, VertexPointMap target,
             const NamedParameters& np = CGAL::parameters::default_values()) const;

/*!
writes the image of each point on the boundary of a mesh of arrays, in the same way.

\param points the points, a random access range as `CGAL::stretch_minimizing_volume_parameterization()` takes it
\param cells four indices of points each, such that all cells are positive
\param targets receives an image for each point. Interior points receive coordinates that are not numbers.
\param np the same named parameters

\return the same. The function throws `Input_error` like `CGAL::stretch_minimizing_volume_parameterization()`.
*/
template <typename PointRange, typename CellRange, typename TargetRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
CGAL::Volume_mesh_parameterization::Error_code
parameterize(const PointRange& points, const CellRange& cells, TargetRange& targets,
             const NamedParameters& np = CGAL::parameters::default_values()) const;

/// @}
};
