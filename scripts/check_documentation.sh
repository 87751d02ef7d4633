#!/usr/bin/env bash
# Fails unless the manual lists all that a user can name: named parameters, headers, examples, and options of the program.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
package=Volume_mesh_parameterization
headers="$root/include/CGAL"
examples="$root/examples/$package"
doc="$root/doc/$package"
status=0

# Complains about each line of the standard input, names of one kind, that is no word of the file.
require()
{
  while read -r name; do
    if ! grep -qwF -e "$name" "$2"; then
      echo "$2 lacks the $1 $name"
      status=1
    fi
  done
}

require "named parameter" "$headers/stretch_minimizing_volume_parameterization.h" < <(
  sed -n 's/^CGAL_add_named_parameter(.*, \(.*\))/cgalParamNBegin{\1}/p' \
    "$headers/STL_Extension/internal/parameters_interface.h")
require "class or function of header" "$doc/PackageDescription.txt" < <(
  cd "$headers" && ls ./*.h "$package"/*.h | xargs -n 1 basename | sed 's/\.h$//' | grep -v Parameterization_step)
require "example" "$doc/examples.txt" < <(cd "$examples" && ls ./*.cpp parameterize_mesh_file/*.cpp | xargs -n 1 basename)
require "option" "$doc/Parameterize_mesh_file.txt" < <(
  sed -n 's/^ *("\([a-z-]*\)[,"].*/`--\1/p' "$examples/parameterize_mesh_file/Command_line.h" | grep -v -e --source -e --target)
exit $status
