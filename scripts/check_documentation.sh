#!/usr/bin/env bash
# Fails unless the manual lists all that a user can name, classes, functions, examples, and options of the program, and each
# class, overload of a function, public member and named parameter has a comment for Doxygen. With --list, each of these is printed.
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

# Prints the header, the name, and 1 or 0 for with or without a comment, of each class and function in a public namespace and of
# each public member of a class. Members are indented by two blanks, and destructors and deleted functions need no comment.
list_declarations()
{
  local header
  for header in "$@"; do
    awk -v header="${header#"$headers"/}" '
      /^namespace (internal|.*::internal) / { is_internal = 1 }
      /^} \/\/ namespace .*internal/        { is_internal = 0; next }
      /^#ifndef DOXYGEN_RUNNING/            { is_hidden = 1 }
      /^#(else|endif)/                      { is_hidden = 0 }
      is_internal || is_hidden || /^ *\/\/[^\/]/ { next }
      /^ *\/\*!/ || /^ *\/\/\/([^<]|$)/     { is_documented = 1; is_comment = is_comment || /\/\*!/ }
      /\*\/$/                               { is_comment = 0; next }
      is_comment || /^ *\/\/\//             { next }
      /^(class|struct|enum( class)?) [A-Za-z_0-9]+( .*)?[^;]?$/ {
        name = /^enum class/ ? $3 : $2
        print header, name, is_documented + 0
        of_class = /^enum/ ? "" : name
        is_public = /^struct/
      }
      /^};/                                 { of_class = "" }
      /^(public|protected|private):/        { is_public = /^public/ }
      /^[A-Za-z][A-Za-z_0-9:<>,&* ]*\(/ && !/^(template|typename|static_assert|explicit|friend|CGAL_)/ {
        name = $0; sub(/\(.*/, "", name); sub(/.*[ &*]/, "", name); print header, name, is_documented + 0
      }
      of_class != "" && is_public && !/= delete/ && !/^  (template|typename|static_assert|using [A-Za-z_:<>]*[:;]|friend class)/ &&
      /^  [A-Za-z][]A-Za-z_0-9:<>,&*. []*(\(| = |[;{])/ {
        name = $0; sub(/^  using /, "  ", name); sub(/( *=.*|[({;].*)/, "", name); sub(/.*[ &*]/, "", name)
        print header, of_class "::" name, is_documented || /\/\/\/</
      }
      /[;{}]( *\/\/.*)?$/ || /^$/ || /^(public|private):/ { is_documented = 0 }
    ' "$header"
  done
}

# Prints the header with the comments of a function, the name, and 1 or 0, of each named parameter that the function reads.
list_named_parameters()
{
  local file header name
  grep -rl 'check_named_parameters<internal_np::' "$headers" | sort | while read -r file; do
    header=$file
    [[ $file != */named_parameters_3.h ]] || header="$headers/stretch_minimizing_volume_parameterization.h"
    { sed -n '/check_named_parameters<internal_np::/,/;/p' "$file" | grep -o 'internal_np::[a-z_]*' |
        sed 's/internal_np:://; s/_t$//; s/^vertex_.*/&_map/'; printf 'visitor\nmaximum_running_time\n'; } |
      while read -r name; do
        echo "${header#"$headers"/} $name $(grep -cF "cgalParamNBegin{$name}" "$header")"
      done
  done
}

of_package=("$headers"/*.h "$headers/$package"/*.h "$headers/$package"/{IO,Distributed}/*.h)
of_polycubes=("$headers/$polycubes"/*.h "$headers/$polycubes"/IO/*.h)
declarations=$(list_declarations "${of_package[@]}")
declarations_of_polycubes=$(list_declarations "${of_polycubes[@]}")
all=$(echo "$declarations"; echo "$declarations_of_polycubes"; list_named_parameters)
if [ "${1:-}" = --list ]; then
  awk '{ print $1, $2, $3 ? "is documented" : "is not documented" }' <<< "$all"
fi
names() { awk '$2 !~ /::/ { print $2 }' | sort -u; }
require "class or function" "$doc/PackageDescription.txt" < <(names <<< "$declarations")
require "class or function" "$root/doc/$polycubes/PackageDescription.txt" < <(names <<< "$declarations_of_polycubes")
while read -r header name; do
  echo "$header: $name has no comment for Doxygen"
  status=1
done < <(awk '!$3 { print $1, $2 }' <<< "$all")
require "example" "$doc/examples.txt" < <(cd "$examples" && ls ./*.cpp parameterize_mesh_file/*.cpp | xargs -n 1 basename)
require "example" "$root/doc/$polycubes/examples.txt" < <(cd "$root/examples/$polycubes" && ls ./*.cpp | xargs -n 1 basename)
require "option" "$doc/Parameterize_mesh_file.txt" < <(
  sed -n 's/^ *("\([a-z-]*\)[,"].*/`--\1/p' "$examples/parameterize_mesh_file/Command_line.h" | grep -v -e --source -e --target)
# Quoted code is whole: an excerpt of a program closes its brackets and ends a statement, and each line of other code is a line of
# a program or a test.
while read -r complaint; do
  echo "$complaint"
  status=1
done < <(
  awk -v examples="$root/examples/" '
    function show(line) { # without strings and comments
      gsub(/"([^"\\]|\\.)*"/, "", line); sub(/ *\/\/.*/, "", line)
      depth += gsub(/[(\[{]/, "&", line) - gsub(/[)\]}]/, "&", line)
      if(line != "") is_whole = depth == 0 && line ~ /[;}]$/
    }
    is_excerpt && !/^\\(until|line) / { if(!is_whole) print place ": the excerpt ends within a statement"; is_excerpt = 0 }
    /^\\dontinclude / { size = 0; at = 1; while((getline line < (examples $2)) > 0) text[++size] = line; close(examples $2) }
    /^\\(skip|until|line) / { pattern = substr($0, index($0, " ") + 1) }
    /^\\skip / { depth = 0; while(at < size && !index(text[at], pattern)) ++at }
    /^\\(until|line) / {
      do show(text[at]); while(!index(text[at++], pattern) && at <= size)
      is_excerpt = 1; place = FILENAME ":" FNR
    }' "$root"/doc/*/*.txt
  awk '/^\\endcode/ { is_code = 0 }
       is_code && NF { sub(/^ +/, ""); print FILENAME ":" FNR "\t" $0 }
       /^\\code\{\.cpp\}/ { is_code = 1 }' "$root"/doc/*/*.txt |
    while IFS=$'\t' read -r place line; do
      grep -rqF --include=*.cpp -e "$line" "$root"/examples "$root"/test || echo "$place: no program has this line"
    done)
# Each figure is in a text, and a section that speaks of the table has one, or the paragraph refers to it.
while read -r figure; do
  grep -rqF -e "$figure" "$root"/doc/*/*.{txt,md} "$root/README.md" || { echo "$figure: no text shows this figure"; status=1; }
done < <(cd "$doc/fig" && ls)
while read -r place; do
  echo "$place: there is no table in this section"
  status=1
done < <(
  awk 'function report(  i) { for(i in missing) { if(!has_table) print missing[i]; delete missing[i] } has_table = 0 }
       function end_paragraph() { if(place != "" && !refers) missing[place] = place; place = ""; refers = 0 }
       FNR == 1 || /^\\(section|defgroup) / || /^## / { end_paragraph(); report() }
       /^$/ { end_paragraph() }
       /^ *\| *---/ { has_table = 1 }
       /\\(ref|link)/ { refers = 1 }
       /[Tt]he table([^s]|$)/ { if(place == "") place = FILENAME ":" FNR }
       END { end_paragraph(); report() }' "$root"/doc/*/*.{txt,md})
# Doxygen would take a number with a period at the beginning of a line for a list.
while read -r place; do
  echo "$place: a line of text begins with a number and a period"
  status=1
done < <(awk '{ text = $0; sub(/^ *\/\/\/ */, "", text); is_item = text ~ /^[0-9]+[.] / }
              FNR > 1 && is_item && previous != "" && !was_item { print FILENAME ":" FNR }
              { previous = text; was_item = is_item }' \
           "$root"/doc/*/*.{txt,md} "$doc"/Concepts/*.h "${of_package[@]}" "${of_polycubes[@]}")
exit $status
