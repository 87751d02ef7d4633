// The order of attempts to map a mesh to a polycube whose boundary is split for that.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MAPPED_WITH_SPLITS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MAPPED_WITH_SPLITS_H

#include <optional>
#include <utility>

// Finds the map to the polycube of a boundary that is split for it. It has far more vertices than there are inside, and each of
// these may be joined to too many: where no map is found with the boundary held, at most in a third of the time, all edges inside
// that begin at the boundary are split. Only then the boundary may be let go, which takes far longer. If the boundary as it is
// given has a polycube, too, a quarter of the time that is left then is kept for that, which has far fewer cells.
//
// Takes the mesh with targets, of any type with `is_success()` and `has_valid_map()`; `with_boundary_held(mesh)` and
// `with_map(mesh)`, which return the mesh with its map; `with_edges_split(mesh)`; `without_splits()`, which returns an optional
// mesh with targets; and the clock.
template <typename Mesh, typename HoldBoundary, typename Map, typename SplitEdges, typename FindOther, typename Clock>
Mesh mapped_with_splits(const Mesh& with_targets, const HoldBoundary& with_boundary_held, const Map& with_map,
                        const SplitEdges& with_edges_split, const FindOther& without_splits, Clock& clock)
{
  clock.end_after_part_of_time(1. / 3);
  Mesh best = with_boundary_held(with_targets);
  clock.end_after_all_time();
  if(best.is_success() || !clock.goes_on())
    return best;
  clock.end_after_part_of_time(0.5);
  const std::optional<Mesh> other_targets = without_splits();
  clock.end_after_all_time();
  if(other_targets)
    clock.end_after_part_of_time(0.75);
  const auto attempt = [&](const Mesh& mesh)
  {
    Mesh mapped = with_map(mesh);
    if(mapped.is_success() || !best.has_valid_map())
      best = std::move(mapped);
  };
  if(clock.goes_on())
    attempt(with_edges_split(with_targets));
  clock.end_after_all_time();
  if(!best.is_success() && other_targets && clock.goes_on())
    attempt(*other_targets);
  return best;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MAPPED_WITH_SPLITS_H
