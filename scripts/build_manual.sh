#!/usr/bin/env bash
# Installs what is missing and builds the manual in build/doc_output; a warning of Doxygen is an error. With --open, the
# browser shows it.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
doc=doc/Volume_mesh_parameterization
output=build/doc_output # all paths are relative: Doxygen splits the absolute ones at spaces
version=$(sed -n 's/^project(.* VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)

# Copies a configuration with the variables that CGAL's documentation system would set. The title has the version of this
# package, as it does not come with a version of CGAL.
configure()
{
  sed -e "s|\${CGAL_DOC_PACKAGE_DEFAULTS}|$output/defaults|g" \
      -e "s|CGAL \${CGAL_DOC_VERSION} - \([^\"]*\)|\1 $version|g" \
      -e "s|\${CGAL_PACKAGE_DIR}|.|g" -e "s|\${CGAL_PACKAGE_DOC_DIR}|$doc|g" \
      -e "s|\${CGAL_PACKAGE_INCLUDE_DIR}|include|g" "$1" > "$2"
}

# texlive-binaries has bibtex for the bibliography; libjs-mathjax shows the formulas.
scripts/install_dependencies.sh doxygen texlive-binaries libjs-mathjax
rm -rf $output
mkdir -p $output
configure scripts/manual/defaults.in $output/defaults
configure $doc/Doxyfile.in $output/Doxyfile
# Named parameters become functions of a page of their own, by which they can be found and linked: with the type and the default of
# each function that has them.
perl -0777 -ne '
  while(/\\cgalParamNBegin\{(\w+)\}(.*?)\\cgalParamNEnd/sg)
  {
    ($name, $block) = ($1, $2);
    for $key ("Description", "Type", "Default")
    { ($value{$key}) = $block =~ /\\cgalParam$key(\{(?:[^{}]|(?1))*\})/; $value{$key} = substr($value{$key}, 1, -1) =~ s/\s*\n\s*/ /gr }
    $text{$name} //= $value{Description};
    push @{$functions{$name}{"/// - Type: $value{Type}\n/// - Default: $value{Default}\n"}}, $ARGV =~ s|include/(.*)\.h|$1|r =~ s|/|::|gr;
  }
  END
  {
    print "/// \\defgroup PkgVolumeMeshParameterizationNamedParameters Named Parameters\n/// \\ingroup PkgVolumeMeshParameterizationRef\n/// The named parameters of all functions.\n";
    print "namespace CGAL {\n/// Named parameters of functions.\nnamespace parameters {\n";
    for $name (sort keys %text)
    {
      print "/// \\ingroup PkgVolumeMeshParameterizationNamedParameters\n/// $text{$name}\n///\n",
            (map { "$_/// - Parameter of: " . join(", ", map { "`$_()`" } @{$functions{$name}{$_}}) . "\n" } sort keys %{$functions{$name}}),
            "unspecified_type $name(value_type value);\n";
    }
    print "} }\n";
  }' include/CGAL/stretch_minimizing_volume_parameterization.h include/CGAL/*/make_*.h > $output/named_parameters.h
echo 'INPUT += doc/Polycube_meshing_3 build/doc_output/named_parameters.h' >> $output/Doxyfile # one manual here
BIBINPUTS=. BSTINPUTS=. doxygen $output/Doxyfile # bibtex finds files without a TeX installation
# As in CGAL's manual, concepts are called so, and they and named parameters have no header; the tree has room for names without namespaces and parameters.
for concept in $doc/Concepts/*.h; do
  name=$(basename "$concept" .h)
  sed -i "s/$name Class Reference/$name Concept Reference/; /#include.*Concepts\/$name/d" "$output/html/class${name//_/__}.html"
done
sed -i -E '/#include.*named_parameters.h/d; /^<p>Inherited by /d' $output/html/{*NamedParameters,struct*}.html
# Names of named parameters are links to them.
perl -0777 -i -pe '
  BEGIN { open($file, glob("'$output'/html/*NamedParameters.html")); $page = <$file>;
          $anchor{$2} = $1 while $page =~ /id="(\w+)"[^>]*><\/a>\s*<h2 class="memtitle"><span.*?<\/span>(\w+)\(/g }
  s|<code>(\w+)(\([^<]*\))?</code>|$anchor{$1} ? "<a class=\"el\" href=\"group__PkgVolumeMeshParameterizationNamedParameters.html#$anchor{$1}\">$&</a>" : $&|ge
' $output/html/{index,class*,struct*,group*,*Manual,*Paper}.html
if grep -n '`' $output/html/{index,Pkg,class,struct,group,namespace}*.html; then
  echo "Doxygen did not read the code in these lines" >&2
  exit 1
fi
sed -i -E 's/"CGAL::((Volume_mesh_parameterization|Polycube_meshing_3)::)?(IO::)?([A-Za-z])/"\4/; s/< [A-Za-z_]+ >"/"/; s/"(Volume_mesh_parameterization|Polycube_meshing_3)\/([^"]*\.(cpp|h)")/"\2/' $output/html/*.js
echo "Open $PWD/$output/html/index.html"
if [ "${1:-}" = --open ]; then
  xdg-open "$PWD/$output/html/index.html"
fi
