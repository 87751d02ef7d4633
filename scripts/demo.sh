#!/usr/bin/env bash
# Installs what is missing, meshes CGAL's elephant, maps it to a ball and to a cube, and writes files for ParaView.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
programs="$root/build/examples/Volume_mesh_parameterization"
elephant="$root/build/data/meshes/elephant.off"

# Tells what comes next, and at what time of this run.
step() { printf '\n[%d:%02d] %s\n' $((SECONDS / 60)) $((SECONDS % 60)) "$*"; }

echo "This takes about ten minutes on two processors, nearly all of it for compiling; the second time, seconds."
step "1 of 4: the Debian packages that are missing"
"$root/scripts/install_dependencies.sh"
step "2 of 4: the configuration of the build"
cmake -S "$root" -B "$root/build"
step "3 of 4: compiling; some files take minutes each"
cmake --build "$root/build" --parallel "$(nproc)" --target demo
step "4 of 4: the elephant is meshed and mapped, in seconds"
for domain in ball cube; do
  echo
  echo "The elephant to the $domain:"
  "$programs/elephant_to_$domain" "$elephant" "$root/build/elephant_to_$domain.vtu"
done

step "Open in ParaView: $root/build/elephant_to_{ball,cube}.vtu"
echo "(vectors uvw: the map; filter Calculator with Coordinate Results: uvw shows the image)"
printf 'For meshes of your own: %q SOURCE.mesh --to ball --refine -o OUT.vtu\n' "$programs/parameterize_mesh_file"
