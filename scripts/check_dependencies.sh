#!/usr/bin/env bash
# Fails unless package_info/dependencies is sorted and lists the CGAL package of each header of CGAL that is included.
# The list holds more, the packages that those need in turn.
set -euo pipefail
export LC_ALL=C

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# The package in which CGAL keeps a header.
package_of()
{
  case $1 in
    Volume_mesh_parameterization/* | stretch_minimizing_volume_parameterization.h) echo Volume_mesh_parameterization ;;
    Polycube_meshing_3/*) echo Polycube_meshing_3 ;;
    STL_Extension/internal/parameters_interface.h) echo STL_Extension ;;
    license/*) basename "$1" .h ;;
    license.h | config.h | version.h) echo Installation ;;
    Named_function_parameters.h | algorithm.h | assertions.h | exceptions.h | iterator.h | tags.h) echo STL_Extension ;;
    AABB_*) echo AABB_tree ;;
    Box_intersection_d/* | box_intersection_d.h) echo Box_intersection_d ;;
    IO/polygon_soup_io.h) echo Stream_support ;;
    Intersections_3/*) echo Intersections_3 ;;
    Rational_traits.h | number_utils.h) echo Algebraic_foundations ;;
    Exact_integer.h | Exact_rational.h) echo Number_types ;;
    Bbox_3.h | Exact_predicates_inexact_constructions_kernel.h | determinant.h) echo Kernel_23 ;;
    property_map.h) echo Property_map ;;
    boost/graph/*) echo BGL ;;
    Eigen_solver_traits.h) echo Solver_interface ;;
    Polygon_2_algorithms.h) echo Polygon ;;
    Random.h) echo Random_numbers ;;
    Real_timer.h) echo Profiling_tools ;;
    Simple_cartesian.h) echo Cartesian_kernel ;;
    Spatial_sort_traits_adapter_3.h | hilbert_sort.h) echo Spatial_sorting ;;
    Orthogonal_k_neighbor_search.h | Search_traits.h) echo Spatial_searching ;;
    Surface_mesh.h) echo Surface_mesh ;;
    Union_find.h) echo Union_find ;;
    centroid.h) echo Principal_component_analysis_LGPL ;;
    Polygon_mesh_processing/*) dirname "$1" ;;
    *) echo "the unknown package of <CGAL/$1>" ;;
  esac
}

# Checks the list of a package whose headers are in the folders given.
check()
{
  local list="$root/package_info/$1/dependencies" included packages missing
  shift
  included=$(cd "$root/include/CGAL" && grep -rhoE '^ *#\s*include(_next)? <CGAL/[^>]+' "$@" | sed 's|.*<CGAL/||' | sort -u)
  packages=$(for header in $included; do package_of "$header"; done | sort -u)
  missing=$(comm -23 <(echo "$packages") <(sort "$list"))
  sort --check --unique "$list"
  if [ -n "$missing" ]; then
    echo "Not in $list:"
    echo "$missing"
    exit 1
  fi
}

check Volume_mesh_parameterization Volume_mesh_parameterization stretch_minimizing_volume_parameterization.h STL_Extension license
check Polycube_meshing_3 Polycube_meshing_3
