#!/usr/bin/env bash
# Builds the other programs of the page on public sets in FOLDER, and compares them by compare_programs.py.
#
#   compare_with_others.sh PARAMETERIZE_MESH_FILE FOLDER --set NAME=FOLDER ... [options of compare_programs.py]
#   compare_with_others.sh run PROGRAM SOURCE TARGET OUTPUT [REFINED]     (as compare_programs.py calls it)
#
# The first command needs git, cmake, NLopt, SuiteSparse, CGAL and GMP. COMMITS has the version of each program.
set -euo pipefail
here=$(realpath "${BASH_SOURCE[0]}")
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

COMMITS="
TLC duxingyi-charles/lifting_simplices_to_find_injectivity 937d217
IsoTLC duxingyi-charles/Constrained-Injective-Mappings f982767
FFM ssloy/invertible-maps b3f2048
ultimaille ssloy/ultimaille 7fd8c44
ultimaille/ext/stlbfgs ssloy/stlbfgs 0a67abf
VolumeFitting fprotais/Mesh_optimization e2aaad2
GalaxyMaps SteffenHinderink/GalaxyMaps 65d7697
GalaxyMaps/ext/OpenVolumeMesh OpenVolumeMesh/OpenVolumeMesh b25ed99"

# Prints the options of TLC, or of Isometric TLC, whose example says them. Both stop at the first valid map.
options_of()
{
  if [ "$1" = TLC ]; then
    printf '%s\n' form Tutte alphaRatio 1e-6 alpha -1 ftol_abs 1e-8 ftol_rel 1e-8 xtol_abs 1e-8 xtol_rel 1e-8 algorithm LBFGS \
      maxeval 10000 stopCode all_good record vert 0 energy 0 minArea 0
  else
    printf '%s\n' form harmonic alpha 1e-4 lambda1 0.16666666666666666 lambda2 0 k 1 scale_rest_mesh 1 \
      subtract_total_signed_area 1 ftol_abs -1 ftol_rel 1e-9 xtol_abs -1 xtol_rel 1e-9 gtol_abs 1e-6 algorithm Projected_Newton \
      maxeval 10000 lineSearchGamma 1e-4 stopCode no_flip_degenerate record vert 0 energy 0 minArea 0 grad 0 gradNorm 0 \
      searchDirection 0 searchNorm 0 stepSize 0 stepNorm 0 initSingularValues 0 resultSingularValues 0 lastNonFlip 0
  fi
}

run() # PROGRAM SOURCE TARGET OUTPUT [REFINED]
{
  bin=$(dirname "$here")/bin
  [ -d "${PROGRAMS:-$bin}" ] && bin=${PROGRAMS:-$bin}
  work=$(mktemp -d)
  trap 'rm -r "$work"' EXIT
  begin=$EPOCHREALTIME
  seconds() { awk -v a="$begin" -v b="$1" -v c="${2:-0}" 'BEGIN { print "untangled at " b - a + c " s" }'; }
  "$bin/convert_case" begin "$2" "$3" "$work"
  case $1 in
    TLC | IsoTLC)
      options_of "$1" > "$work/options"
      "$bin/$1" "$work/input" "$work/options" "$work/result"
      seconds "$EPOCHREALTIME"
      "$bin/convert_case" end "$work" "$work/result" "$4" ;;
    FFM | VolumeFitting)
      started=$EPOCHREALTIME
      if [ "$1" = FFM ]; then
        "$bin/FFM" "$work/start.mesh" "$work/rest.mesh" "$work/result.mesh"
      else
        "$bin/VolumeFitting" "$work"
      fi 2>&1 | tee "$work/log"
      first=$(grep -m 1 -oP '^valid after \K\S+' "$work/log" || true)
      [ -z "$first" ] || seconds "$started" "$first"
      "$bin/convert_case" end "$work" "$work/result.mesh" "$4" ;;
    GalaxyMaps)
      "$bin/GalaxyMaps" "$work/source.vtk" "$work/start.vtk" -t -o "$work/result"
      seconds "$EPOCHREALTIME"
      "$bin/convert_case" copy "$work" "$work/result_object.vtk" "$5"
      "$bin/convert_case" end "$work" "$work/result_parameter.vtk" "$4" ;;
  esac
}

build() # in FOLDER
{
  while read -r name repository commit; do
    [ -n "$name" ] || continue
    [ -e "$name/.git" ] || git clone --quiet "https://github.com/$repository" "$name"
    [[ $(git -C "$name" rev-parse HEAD) == "$commit"* ]] || git -C "$name" checkout --quiet "$commit"
  done <<< "$COMMITS"
  mkdir -p bin
  include=$(dirname "$here")/../../../include
  compile() # NAME ARGUMENTS, unless it is there
  {
    [ -x "bin/$1" ] || c++ -std=c++17 -O3 -DNDEBUG -march=native -DCGAL_EIGEN3_ENABLED -I"$include" -I/usr/include/eigen3 \
      -I/usr/include/suitesparse -w "${@:2}" -o "bin/$1" -lgmpxx -lgmp -lmpfr
  }
  compile convert_case "$(dirname "$here")/convert_case.cpp"
  compile TLC TLC/TLC.cpp -lnlopt
  compile IsoTLC -IIsoTLC/src IsoTLC/apps/sTGC_3D_PN.cpp \
    IsoTLC/src/{sTGC_3D_Formulation,Total_Generalized_Content_3D,optimization_util,deformation_gradient_util,geo_util}.cpp -lcholmod
  # FFM does not report the first positions without inverted cells.
  first='static bool is_valid = false;\
    static const auto begin = std::chrono::steady_clock::now();\
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;\
    if(!ninverted \&\& !is_valid)\
      std::cout << "valid after " << seconds.count() << " s" << std::endl, is_valid = true;'
  sed "/^                evaluate_jacobian(X);/a $first" FFM/cpp/untangle3d.cpp > untangle3d.cpp
  cmake -S ultimaille -B ultimaille/build -DBUILD_SHARED_LIBS=OFF > /dev/null 2>&1
  cmake --build ultimaille/build --target ultimaille > /dev/null
  mapfile -t libraries < <(find ultimaille/build -name '*.a')
  compile FFM -fopenmp -Iultimaille -Iultimaille/ext untangle3d.cpp -Wl,--start-group "${libraries[@]}" -Wl,--end-group
  compile VolumeFitting -IVolumeFitting "$(dirname "$here")/fit_volume.cpp"
  if [ ! -x bin/GalaxyMaps ]; then
    cmake -S GalaxyMaps -B GalaxyMaps/build -DGUI=OFF > /dev/null 2>&1
    cmake --build GalaxyMaps/build > /dev/null 2>&1
    ln -s ../GalaxyMaps/build/galaxy_map bin/GalaxyMaps
  fi
}

if [ "$1" = run ]; then
  shift
  run "$@"
  exit
fi
driver=$(realpath "$1")
mkdir -p "$2"
folder=$(realpath "$2")
shift 2
(cd "$folder" && build)
# TLC, FFM and Galaxy Maps need the whole boundary, and Galaxy Maps a star-shaped target.
declare -A takes=([TLC]='^(?!handles/)' [FFM]='^(?!handles/)' [GalaxyMaps]='^(volmap|channels)/')
version=$(git -C "$(dirname "$here")" log -1 --format='commit %h of %cs')
externals=(--version "parameterize_mesh_file=$version")
while read -r name repository commit; do
  [ -f "$folder/bin/$name" ] || continue
  date=$(git -C "$folder/$name" log -1 --format=%cs)
  refined=$([ "$name" != GalaxyMaps ] || echo "{refined}") # the others add no vertices
  externals+=(--external "$name=env PROGRAMS=$folder/bin $here run $name {source} {target} {output} $refined"
    --first-valid "$name=untangled at (\\S+) s" --takes "$name=${takes[$name]:-}"
    --version "$name=$repository at $commit of $date")
done <<< "$COMMITS"
exec "$(dirname "$here")/../compare_programs.py" "$driver" --options "--refine --threads 1" "${externals[@]}" "$@"
