#!/usr/bin/env bash
# Fails unless each header includes only headers of its own part and of parts below it. A part is a folder of internal/
# with the public headers that are listed here. Those of the package Polycube_meshing_3 are above those of the other one, and do
# not know each other.
set -euo pipefail
export LC_ALL=C

cd "$(dirname "${BASH_SOURCE[0]}")/../include/CGAL"
package=Volume_mesh_parameterization

# Sets REPLY to the part of a header.
part_of()
{
  local header=${1#*/}
  if [[ $1 == Polycube_meshing_3/* ]]; then
    case $header in
      internal/Polycube/* | Polycube_*.h) REPLY=Polycube ;;
      internal/Hexahedra/* | Hexahedr*.h | make_hexahedral_mesh_3.h) REPLY=Hexahedra ;;
      internal/basic.h) REPLY=basic ;;
      IO/*) REPLY=IO_of_hexahedra ;;
      *) REPLY="no part" ;;
    esac
    return
  fi
  case $header in
    stretch_minimizing_volume_parameterization.h | volume_parameterization_of_arrays.h | make_parameterizable.h) REPLY=Entry ;;
    internal/*/*) header=${header#internal/}; REPLY=${header%%/*} ;;
    Parameterization_parameters.h | Parameterization_result.h | select.h) REPLY=Support ;;
    *_energy_3.h | check_derivatives.h) REPLY=Energies ;;
    Block_sparse_matrix_3.h | *_solver_traits_3.h) REPLY=Solvers ;;
    *_surface_3.h | Surface_intersection_3.h | Vertex_condition_3.h | Vertex_map.h | measure_distortion.h | measure_forces.h) REPLY=Map ;;
    Tetrahedron_soup_3.h | conditions_of_patches.h | mesh_complex_3_to_tetrahedron_soup.h | orient_tetrahedron_soup.h | \
      repair_tetrahedron_soup.h | tetrahedron_soup_to_mesh_complex_3.h) REPLY=Soups ;;
    Volume_map_3.h) REPLY=Evaluation ;;
    *_boundary_parameterizer_3.h | boundary_vertices.h | measure_surface_fit.h) REPLY=Boundary ;;
    IO/*.h) REPLY=IO ;;
    Distributed/*.h) REPLY=Distributed ;;
    *) REPLY="no part" ;;
  esac
}

# Sets REPLY to the parts that a part may include besides itself.
parts_below()
{
  case $1 in
    Energies | Solvers) REPLY="Support" ;;
    Map) REPLY="Energies Solvers Support" ;;
    Boundary | Evaluation) REPLY="Map Energies Solvers Support" ;;
    Soups) REPLY="Boundary Evaluation Map Energies Solvers Support" ;;
    Entry | IO) REPLY="Soups Boundary Evaluation Map Energies Solvers Support" ;;
    Distributed) REPLY="Entry IO Soups Boundary Evaluation Map Energies Solvers Support" ;;
    basic) REPLY="Support" ;;
    Polycube | Hexahedra) REPLY="basic Soups Boundary Evaluation Map Energies Solvers Support" ;;
    IO_of_hexahedra) REPLY="Hexahedra IO Soups Boundary Evaluation Map Energies Solvers Support" ;;
  esac
}

status=0
while IFS=: read -r header included; do
  part_of "$header"; part=$REPLY
  part_of "$included"; other=$REPLY
  REPLY=""; parts_below "$part"
  if [ "$part" = "no part" ] || [[ " $part $REPLY " != *" $other "* ]]; then
    echo "$header ($part) includes $included ($other)"
    status=1
  fi
done < <(grep -roE '^ *#\s*include <CGAL/[^>]+' "$package" Polycube_meshing_3 stretch_minimizing_volume_parameterization.h |
           sed 's|: *#\s*include <CGAL/|:|' | grep -E ":($package|Polycube_meshing_3)/" | sort)
# The map knows points, cells and marked edges, and nothing that only files have.
if grep -rnE 'soup\.|[Tt]etrahedron_soup|Data_array|group_name|notes' "$package"/internal/{Map,Boundary,Evaluation}; then
  status=1
fi
exit $status
