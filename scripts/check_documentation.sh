#!/usr/bin/env bash
# Fails unless the manual lists all that a user can name, classes, functions, named parameters, examples, and options of the
# program, and each class and overload of a function has a comment for Doxygen. With --list, each of them is printed.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
package=Volume_mesh_parameterization
polycubes=Polycube_meshing_3
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
    "$headers/STL_Extension/internal/parameters_interface.h" | grep -v -e minimum_scaled_jacobian -e do_keep_interfaces)
require "named parameter" "$headers/$polycubes/make_hexahedral_mesh_3.h" \
  <<< $'cgalParamNBegin{minimum_scaled_jacobian}\ncgalParamNBegin{do_keep_interfaces}'

# Prints the header, the name, and 1 or 0 for with or without a comment, of each class and function in a public namespace.
list_declarations()
{
  local header
  for header in "$@"; do
    awk -v header="${header#"$headers"/}" '
      /^namespace (internal|.*::internal) / { is_internal = 1 }
      /^} \/\/ namespace .*internal/        { is_internal = 0; next }
      is_internal || /^ *\/\/[^\/]/         { next }
      /^\/\*!/ || /^\/\/\//                 { is_documented = 1; is_comment = /^\/\*!/ }
      /\*\/$/                               { is_comment = 0; next }
      is_comment || /^\/\/\//               { next }
      /^(class|struct|enum( class)?) [A-Za-z_0-9]+( .*)?[^;]?$/ { sub(/^enum class/, "enum"); print header, $2, is_documented + 0 }
      /^[A-Za-z][A-Za-z_0-9:<>,&* ]*\(/ && !/^(template|typename|static_assert|explicit|friend|CGAL_)/ {
        sub(/\(.*/, ""); sub(/.*[ &*]/, ""); print header, $0, is_documented + 0
      }
      /[;{}]$/ || /^$/                      { is_documented = 0 }
    ' "$header"
  done
}

of_package=("$headers"/*.h "$headers/$package"/*.h "$headers/$package"/{IO,Arrays,Distributed}/*.h)
of_polycubes=("$headers/$polycubes"/*.h "$headers/$polycubes"/IO/*.h)
if [ "${1:-}" = --list ]; then
  list_declarations "${of_package[@]}" "${of_polycubes[@]}" | awk '{ print $1, $2, $3 ? "is documented" : "is not documented" }'
fi
require "class or function" "$doc/PackageDescription.txt" < <(list_declarations "${of_package[@]}" | awk '{ print $2 }' | sort -u)
require "class or function" "$root/doc/$polycubes/PackageDescription.txt" < <(
  list_declarations "${of_polycubes[@]}" | awk '{ print $2 }' | sort -u)
while read -r header name; do
  echo "$header: $name has no comment for Doxygen"
  status=1
done < <(list_declarations "${of_package[@]}" "${of_polycubes[@]}" | awk '!$3 { print $1, $2 }')
require "example" "$doc/examples.txt" < <(cd "$examples" && ls ./*.cpp parameterize_mesh_file/*.cpp | xargs -n 1 basename)
require "example" "$root/doc/$polycubes/examples.txt" < <(cd "$root/examples/$polycubes" && ls ./*.cpp | xargs -n 1 basename)
require "option" "$doc/Parameterize_mesh_file.txt" < <(
  sed -n 's/^ *("\([a-z-]*\)[,"].*/`--\1/p' "$examples/parameterize_mesh_file/Command_line.h" | grep -v -e --source -e --target)
exit $status
