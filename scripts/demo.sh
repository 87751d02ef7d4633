#!/usr/bin/env bash
# Installs what is missing, compiles one example, maps a cube to a ball by it, and writes a file for ParaView. Draws a picture, too,
# if Xvfb and VTK for Python are there (Debian's packages python3-vtk9, xauth and xvfb).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
examples="$root/examples/Volume_mesh_parameterization"
build="$root/build/demo"

# Prints what comes next, and the time of this run.
step() { printf '\n[%d:%02d] %s\n' $((SECONDS / 60)) $((SECONDS % 60)) "$*"; }

echo "This takes about two minutes, nearly all of it for compiling, and 3 GB of memory."
step "1 of 3: the Debian packages that are missing"
"$root/scripts/install_dependencies.sh" --headers
step "2 of 3: compiling tetrahedron_soup.cpp, for about a minute"
mkdir -p "$build"
g++ -std=c++17 -O1 -DNDEBUG -frounding-math -DCGAL_EIGEN3_ENABLED -I"$root/include" -isystem /usr/include/eigen3 \
  "$examples/tetrahedron_soup.cpp" -o "$build/tetrahedron_soup" -lgmp -lmpfr
step "3 of 3: a cube of 384 cells is mapped to a ball"
ln -sfn "$examples/data" "$build/data"
(cd "$build" && ./tetrahedron_soup)

python=/usr/bin/python3
if command -v xvfb-run > /dev/null && $python -c "import vtk" 2> /dev/null; then
  PYTHONPATH="$root/benchmark/Volume_mesh_parameterization/paper" xvfb-run -a $python - "$build/ball" <<END
import sys
import render
ball = render.image_of(render.read(sys.argv[1] + ".vtu"))
half = render.colored_surface(render.cut(ball, (0, -1, 0)), "angle_distortion", 10)
half.GetProperty().SetEdgeVisibility(True)
render.picture(sys.argv[1] + ".png", [half], (1, -3, 1), (0, 0, 1), "distortion")
END
  step "A picture of one half of the ball: $build/ball.png"
fi
step "Open in ParaView: $build/ball.vtu"
echo "(vectors uvw: the map; filter Calculator with Coordinate Results: uvw shows the image)"
