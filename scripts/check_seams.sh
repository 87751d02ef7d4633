#!/usr/bin/env bash
# Fails unless header-only units and engines compile all seams. A header x_impl.h defines what x.h declares: x.h includes it
# without the engine, and the sources of an engine include it. With an OBJECT of a header-only unit that calls everything, each
# function of the seams must be defined there, and none of the packages twice if a program has two such units.
#
# Usage: scripts/check_seams.sh [OBJECT]
set -euo pipefail
export LC_ALL=C

[ $# -eq 0 ] || set -- "$(realpath "$1")"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
status=0
complain() { echo "$1"; status=1; }

# Prints the functions that the engine compiles of a header, or the one with the name of the header if they are templates.
functions_of()
{
  { grep -hA 2 -E '^CGAL_[A-Z0-9_]*_INLINE' "$1" || true; } | tr '\n' ' ' |
    grep -oE '_INLINE [^(]*\(' | grep -oE '[A-Za-z_0-9:]+\($' | tr -d '(' ||
    grep -ohE "\b(make_)?$(basename "$1" _impl.h)\(" "$1" | head -n 1 | tr -d '('
}

symbols= # mangled: a name has its length before it
[ $# -eq 0 ] || symbols=$(nm --defined-only "$1" | grep -E ' _Z.*(Volume_mesh_parameterization|Polycube_meshing_3)')
while read -r implementation; do
  path=${implementation#include/}
  name=$(basename "$implementation" _impl.h).h
  header=$(find include -name "$name")
  [ -n "$header" ] || { complain "$implementation: there is no $name"; continue; }
  grep -A 1 -xE '#ifndef CGAL_[A-Z0-9_]*_COMPILED_ENGINE' "$header" | grep -qxF "#  include <$path>" ||
    complain "$header: header-only units miss $path"
  grep -qF "#include <$path>" cmake/*Target.cmake || complain "$path: no engine compiles it"
  [ $# -gt 0 ] || continue
  while read -r function; do
    function=${function##*::}
    [[ $symbols == *${#function}$function* ]] || complain "$1: $function() of $path is not called"
  done < <(functions_of "$implementation")
done < <(find include -name '*_impl.h' | sort)
while read -r symbol; do
  complain "$1: $symbol is not inline"
done < <(grep -oP '^\w+ [TDB] \K_ZNK?4CGAL\d+(Volume_mesh_parameterization|Polycube_meshing_3).*' <<< "$symbols" | c++filt)
exit $status
