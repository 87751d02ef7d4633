#!/usr/bin/env bash
# Installs what is missing, meshes CGAL's elephant, maps it onto the twisted elephant and writes a file for ParaView.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
programs="$root/build/examples/Volume_mesh_parameterization"
output="$root/build/elephant_twisted.vtu"

"$root/scripts/install_dependencies.sh"
cmake -S "$root" -B "$root/build"
cmake --build "$root/build" --parallel "$(nproc)" --target mesh_and_parameterize parameterize_mesh_file
"$programs/mesh_and_parameterize" "$root/build/data/meshes/elephant.off" "$output"

echo
echo "Open in ParaView: $output (vectors uvw: the map; filter Calculator with Coordinate Results: uvw shows the image)"
echo "For meshes of your own: $programs/parameterize_mesh_file SOURCE.mesh TARGET --output OUT.vtu"
