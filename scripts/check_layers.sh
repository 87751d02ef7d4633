#!/usr/bin/env bash
# Fails unless each header includes only headers of its own part and of parts below it. A part is a folder of internal/
# with the public headers that are listed here.
set -euo pipefail
export LC_ALL=C

cd "$(dirname "${BASH_SOURCE[0]}")/../include/CGAL"
package=Volume_mesh_parameterization

# The part of a header.
part_of()
{
  case ${1#"$package/"} in
    internal/*/*) cut -d / -f 2 <<< "${1#"$package/"}" ;;
    Default_visitor.h | Error_code.h | Parameterization_step.h | select.h) echo Support ;;
    *_energy_3.h | check_derivatives.h) echo Energies ;;
    Block_sparse_matrix_3.h | *_solver_traits_3.h) echo Solvers ;;
    Boundary_mode.h | Refinement_mode.h | Linear_constraint_3.h | Parameterization_result.h | Soft_boundary_parameters.h | Tetrahedron_soup_3.h | Vertex_point_map.h | \
      make_parameterizable.h | measure_distortion.h | measure_quality.h | merge_coinciding_points.h | mesh_complex_3_to_tetrahedron_soup.h | \
      orient_tetrahedron_soup.h | separate_pinched_vertices.h | tetrahedron_soup_to_mesh_complex_3.h) echo Map ;;
    Volume_map_3.h | cell_distortions.h | evaluate_on_grid.h) echo Evaluation ;;
    *_boundary_parameterizer_3.h | boundary_vertices.h) echo Boundary ;;
    Hexahedral_mesh_result.h | Hexahedron_soup_3.h | hexahedral_mesh.h) echo Hexahedra ;;
    IO/*.h) echo IO ;;
    Distributed/*.h | Distributed_tetrahedron_soup_3.h) echo Distributed ;;
    Arrays/*.h | stretch_minimizing_volume_parameterization.h) echo entry ;;
    *) echo "no part" ;;
  esac
}

# The parts that a part may include besides itself.
parts_below()
{
  case $1 in
    Energies | Solvers) echo Support ;;
    Map) echo Energies Solvers Support ;;
    Boundary | Evaluation) echo Map Energies Solvers Support ;;
    entry | Hexahedra) echo Boundary Evaluation Map Energies Solvers Support ;;
    IO) echo Hexahedra Boundary Evaluation Map Energies Solvers Support ;;
    Distributed) echo IO Hexahedra Boundary Evaluation Map Energies Solvers Support ;;
  esac
}

status=0
while IFS=: read -r header included; do
  part=$(part_of "$header")
  other=$(part_of "$included")
  if [ "$part" = "no part" ] || [[ " $part $(parts_below "$part") " != *" $other "* ]]; then
    echo "$header ($part) includes $included ($other)"
    status=1
  fi
done < <(grep -roE '^ *#\s*include <CGAL/[^>]+' "$package" stretch_minimizing_volume_parameterization.h |
           sed 's|: *#\s*include <CGAL/|:|' | grep ":$package/" | sort)
exit $status
