#!/usr/bin/env bash
# Draws Fig. 6 and 7 of the paper, the convergence of five energies, for a jittered grid that is mapped to a twisted ellipsoid.
# Installs what is missing, builds, and writes build/figure/index.html with the plots and the claims of the paper. It needs no data,
# and a few minutes on two idle cores, most of them for the compiler. reproduce_paper has all figures, with models like those of
# the paper.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
here=$root/benchmark/Volume_mesh_parameterization
build=$root/build/figure

"$root/scripts/install_dependencies.sh" gnuplot-nox
cmake -S "$root" -B "$build" -DCGAL_Volume_mesh_parameterization_BENCHMARKS=ON -DCGAL_Volume_mesh_parameterization_TESTS=OFF
cmake --build "$build" --parallel 2 --target run_soft_boundary measure_map grid_to_ball
"$build/benchmark/Volume_mesh_parameterization/grid_to_ball" 10 "$build/grid"
awk '{ a = 1.5 * $4; print $1, cos(a) * $2 - sin(a) * $3, sin(a) * $2 + cos(a) * $3, 2 * $4 }' "$build/grid_ball.txt" \
  > "$build/grid_ellipsoid.txt"
python3 "$here/paper/figure.py" "$build" "$build/grid.mesh" "$build/grid_ellipsoid.txt" "$build"
