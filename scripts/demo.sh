#!/usr/bin/env bash
# Installs what is missing, meshes CGAL's elephant, maps it to a ball and to a cube, and writes files for ParaView.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
programs="$root/build/examples/Volume_mesh_parameterization"
elephant="$root/build/data/meshes/elephant.off"

"$root/scripts/install_dependencies.sh"
cmake -S "$root" -B "$root/build"
cmake --build "$root/build" --parallel "$(nproc)" --target demo
for domain in ball cube; do
  echo
  echo "The elephant to the $domain:"
  "$programs/elephant_to_$domain" "$elephant" "$root/build/elephant_to_$domain.vtu"
done

echo
echo "Open in ParaView: $root/build/elephant_to_{ball,cube}.vtu"
echo "(vectors uvw: the map; filter Calculator with Coordinate Results: uvw shows the image)"
echo "For meshes of your own: $programs/parameterize_mesh_file SOURCE.mesh --to ball --refine -o OUT.vtu"
