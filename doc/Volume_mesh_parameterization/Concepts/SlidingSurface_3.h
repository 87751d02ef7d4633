/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

A surface or a curve on which vertices slide: see `CGAL::Volume_mesh_parameterization::Vertex_condition_3`. The function is called
by several threads at the same time.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Volume_mesh_parameterization::Any_surface_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Implicit_surface_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Surface_intersection_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Triangulated_surface_3}
\cgalHasModelsEnd
*/
class SlidingSurface_3
{
public:
/// returns the point of the surface to which a point near it is put back, such as the nearest one, with the normal of the surface
/// or the tangent of the curve there. A point of the surface stays, up to rounding: otherwise, the map is no success. If there is no
/// such point, coordinates are not numbers.
CGAL::Volume_mesh_parameterization::Surface_point_3 nearest_point(const std::array<double, 3>& p) const;
};
