#!/usr/bin/env bash
# Fails unless the package keeps those of CGAL's rules that can be checked outside of CGAL's tree. The others are listed in
# doc/Volume_mesh_parameterization/Submission.txt. With an argument, names are compared with those of the CGAL installed in
# that folder.
set -euo pipefail
shopt -s lastpipe # forbid() keeps what it reads from a pipe
export LC_ALL=C

cd "$(dirname "${BASH_SOURCE[0]}")/.."
packages=(Volume_mesh_parameterization Polycube_meshing_3)
cgal=${1:-/usr}/include
status=0

# Complains about each line of the standard input: FILE, or FILE:LINE and what is there.
forbid()
{
  while read -r line; do
    echo "$line: $1"
    status=1
  done
}

# All files of the package, whether or not they come with a history; what is built, or made by Python, is none.
list()
{
  find "${@:-.}" \( -path ./build -o -path ./.git -o -name __pycache__ \) -prune -o -type f -print | sed 's|^\./||' |
    grep -vxF .git | sort
}

mapfile -t files < <(list)
mapfile -t headers < <(list include | grep -E '\.(h|inc)$')
mapfile -t sources < <(list include examples test benchmark | grep -E '\.(h|inc|cpp)$')

# 1. What CGAL's scripts read of a package.
for package in "${packages[@]}"; do
  for name in "package_info/$package"/{copyright,dependencies,description.txt,license.txt,long_description.txt,maintainer} \
              "doc/$package"/{"$package.txt",PackageDescription.txt,Doxyfile.in,dependencies,examples.txt} \
              examples/"$package/CMakeLists.txt" "include/CGAL/license/$package.h" CHANGES.md; do
    [ -s "$name" ] || echo "$name"
  done | forbid "this file is missing or empty"
  [ "$(wc -l < "package_info/$package/description.txt")" -le 1 ] || forbid "one sentence" <<< "package_info/$package/description.txt"
  grep -qxE '(L?GPL) \(v3 or later\)' "package_info/$package/license.txt" ||
    forbid "neither GPL nor LGPL (v3 or later)" <<< "package_info/$package/license.txt"
done

# 2. A licence for each file, by itself or by REUSE.toml; the text of each licence.
mapfile -t annotated < <(sed -n '/^path = \[/,/^\]/p' REUSE.toml | grep -o '"[^"]*"' | tr -d '"')
declare -A is_licensed
while read -r file; do is_licensed[$file]=1; done < <(grep -l 'SPDX-License-Identifier: ' "${files[@]}")
for file in "${files[@]}"; do
  is_annotated=
  for pattern in "${annotated[@]}"; do
    [[ $pattern == '*' && $file == */* ]] || [[ $file != $pattern ]] || is_annotated=1
  done
  [ -n "$is_annotated${is_licensed[$file]:-}" ] || [[ $file == LICENSES/* ]] || echo "$file"
done | forbid "no SPDX-License-Identifier, neither here nor in REUSE.toml"
grep -hoE 'SPDX-License-Identifier(:| =) "?[A-Za-z0-9.-]+' "${headers[@]}" REUSE.toml | sed 's/.*[ "]//' | sort -u |
  while read -r license; do [ -s "LICENSES/$license.txt" ] || echo "LICENSES/$license.txt"; done |
  forbid "the text of a licence is missing"

# 3. The head of each header. Some are included several times, without a guard.
for line in 'Copyright (c) [0-9]' '$URL$$' '$Id$$' 'SPDX-License-Identifier: ' 'Author(s)     : '; do
  { grep -L "^// $line" "${headers[@]}" || true; } | forbid "the head has no line $line"
done
declare -A is_defined first_include
while IFS=: read -r header line; do is_defined["$header $line"]=1; done < <(grep -H '^#define ' "${headers[@]}")
while IFS=: read -r header line; do first_include[$header]=$line; done < <(grep -Hm 1 '^#include' "${headers[@]}")
for header in "${headers[@]}"; do
  case $header in
    *.inc | */parameters_interface.h | include/CGAL/license/*) continue ;;
  esac
  guard=${header#include/}
  guard=${guard^^}
  guard=${guard//[\/.]/_}
  [ -n "${is_defined["$header #define $guard"]:-}" ] || forbid "the guard is not $guard" <<< "$header"
  package=Volume_mesh_parameterization
  [[ $header != */Polycube_meshing_3/* ]] || package=Polycube_meshing_3
  [ "${first_include[$header]:-}" = "#include <CGAL/license/$package.h>" ] ||
    forbid "the licence is not included first" <<< "$header"
done

# 4. Names. Case does not count, and headers and programs of the package have names of their own.
printf '%s\n' "${files[@]}" | tr A-Z a-z | uniq -d | forbid "two files of this name, but for the case"
printf '%s\n' "${headers[@]##*/}" | sort | uniq -d | forbid "two headers of this name"
printf '%s\n' "${headers[@]#include/}" | grep -v parameters_interface | while read -r header; do
  [ ! -e "$cgal/$header" ] || grep -q Volume_mesh_parameterization "$cgal/$header" || echo "$header"
done | forbid "CGAL has a header of this name"
list examples test benchmark | grep '\.cpp$' | sed 's|.*/||' | sort | uniq -d | forbid "two programs of this name"
programs=/usr/share/doc/libcgal-dev/examples.tar.gz
if [ -e "$programs" ]; then
  comm -12 <(tar tzf "$programs" | grep '\.cpp$' | sed 's|.*/||' | sort -u) \
           <(list "${packages[@]/#/examples/}" "${packages[@]/#/test/}" | grep '\.cpp$' | sed 's|.*/||' | sort) |
    forbid "CGAL has a program of this name"
fi

# 5. What compilers and reviewers trip on. Misuse is reported in release builds, too: internal::require() calls CGAL's failure
# function, and CGAL_precondition() has no effect there.
find_lines() { grep -nP "$1" "${sources[@]}" || true; }
find_lines '(\.|->|::)(min|max) ?\(' | forbid "min and max are macros on Windows: (std::min)(a, b)"
find_lines '(?<!static_)\b(assert|abort|exit) ?\(' | { grep '^include' || true; } | forbid "CGAL_assertion() or require()"
# Except in the inside of Polycube_meshing_3, which uses the inside of the other package.
find_lines '^using namespace' | { grep '^[^:]*\.h:' || true; } | { grep -v '/internal/basic\.h:' || true; } |
  forbid "no using namespace in a header"
# Except in maps of other memory, and where users or the sparse solvers have Eigen's own.
find_lines 'Eigen::(Matrix|Vector|Array)([23]?X|[24])' | { grep '^include' || true; } |
  { grep -vE 'Map<|/(Direct_solver_3_impl|Eigen_solver_traits_3|Linear_solver_3|sparse_systems_impl)\.h' || true; } |
  forbid "its memory or alignment depends on the flags of a unit: see internal/Support/Dynamic_matrix.h"
find_lines 'stableNorm\(' | forbid "its rounding depends on the address of the vector: length_3()"
find_lines '\t| +$' | forbid "a tab, or blanks at the end of a line"
find_lines '.{132}' | forbid "a line is longer than 131 characters"
find_lines '[^\x00-\x7F]' | forbid "not ASCII"

# 6. Examples show what users can do.
{ list examples | xargs grep -nE 'internal(::|/)' || true; } | forbid "an example uses internal parts"

# 7. Words. A comment begins with a verb in the third person or with the noun that is declared, and names have terms of the
# field. `goes_on()` is a function of visitors; strings and comments may have all words.
list include examples test benchmark scripts cmake | { grep -E '\.(h|inc|cpp|py|sh|cmake|txt)$' || true; } | xargs perl -ne '
  $mark = $ARGV =~ /\.(py|sh|cmake|txt)$/ ? qr/#/ : qr{//|/\*};
  if(!$is_block && !m{^\s*$mark}) { $has_begun = 0 }
  elsif(m{^\s*(?:$mark)?[/*!]*\s*([^\s\\/].*)} && !$has_begun++)
  { print "$ARGV:$.:$_" if $1 =~ /^(What|That|Those|(The )?same|From|Of|With|\.\.\.)(?!\w)/i }
  $is_block = ($is_block || m{^\s*/\*}) && !m{\*/} if $mark !~ /#/;
  close ARGV, $has_begun = $is_block = 0 if eof' | forbid "a comment begins with a verb or the noun that is declared"
perl -0777 -ne '
  s{R"\((.*?)\)"|"(?:\\.|[^"\\\n])*"|\x27(?:\\.|[^\x27\\\n])\x27|//[^\n]*|/\*.*?\*/}{$& =~ s/[^\n]//gr}gse;
  my $line = 0;
  for(split /\n/)
  { ++$line; print "$ARGV:$line:$_\n" if /most_|_most\b|m(ax|in)imal_|\bgoes_on\b(?!\(\))|judged|(?<![a-z])(?<!in_)places?(?![a-z])/i }' \
  "${sources[@]}" | forbid "a name says index, point or position, maximum_, evaluated or may_continue"
exit $status
