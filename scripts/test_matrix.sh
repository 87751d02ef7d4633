#!/usr/bin/env bash
# Runs all tests with other compilers, standards and libraries than scripts/test.sh does. Prints a line for each
# configuration; its messages are in FOLDER/CONFIGURATION.log. With Gmsh, TetGen and meshio, files of other programs are tested, too.
set -euo pipefail

usage="Usage: scripts/test_matrix.sh [--folder FOLDER] [--cgal PREFIX] [--eigen PREFIX] [CONFIGURATION...]

Without a configuration, all of these, but for the sanitizers and the coverage:
  default      the compiler, the standard and the libraries that CMake finds
  assertions   with the assertions of this package, of CGAL and of Eigen
  library      with the assertions of GNU's C++ library, as some distributions compile all
  sanitizers   clang++ with the sanitizers of addresses and of undefined behaviour; for hours
  fuzz         each reader of files, with damaged files of libFuzzer for two minutes, and the same sanitizers
  coverage     the lines of include/ that tests reach, by part, and a list of those that none reaches; for an hour
  threads      the core: several threads at once, with clang++ and the sanitizer of threads, without TBB, which is not compiled
               for it
  clang        clang++
  clang19      clang++-19, the newest of Debian 12
  minimal      C++20, without TBB, CHOLMOD, PETSc, Gmsh, VTK and what decompresses files
  petsc        the tests with several processes, with the assertions of this package, of CGAL and of Eigen
  cgal         the CGAL installed in the folder given by --cgal
  eigen        the Eigen installed in the folder given by --eigen, and that CGAL
  headers      each header compiled alone by g++ and clang++; no test is run
  optimized    matrices of three columns, and random maps by one thread and by several, by g++ and clang++, with -O2 and -O3 and
               the instructions of this machine
  libc++       the core, with clang++ and its library
  no_gmp       the core, with numbers of Boost in place of those of GMP
  arm64        the core, cross-compiled without GMP, and run by qemu
  windows      the core, cross-compiled by MinGW-w64 without GMP, and run by Wine
  cgal_core    the core, by the compiler in \$CXX, with the headers in the folder given by --cgal, for instance those of an
               archive of CGAL 6, and of a Boost beside it; and all public headers, in C++17 and C++20, with and without
               what that CGAL deprecates
The core is header-only: a map of arrays, and the tests of the public function. It is without TBB, CHOLMOD, PETSc, CGAL's
models and the program parameterize_mesh_file.
FOLDER is build/matrix if not given, and PREFIX the environment variables CGAL_PREFIX and EIGEN_PREFIX; cgal, cgal_core and
eigen are left out without one. Nothing is downloaded but Debian's packages."

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder="$root/build/matrix"
cgal=${CGAL_PREFIX:-}
eigen=${EIGEN_PREFIX:-}
while [ $# -gt 0 ]; do
  case $1 in
    --folder) folder=$2; shift 2 ;;
    --cgal) cgal=$2; shift 2 ;;
    --eigen) eigen=$2; shift 2 ;;
    -*) echo "$usage"; exit 2 ;;
    *) break ;;
  esac
done
configurations=("$@")
if [ $# -eq 0 ]; then
  configurations=(default assertions library fuzz threads clang clang19 minimal petsc ${cgal:+cgal} ${eigen:+eigen} headers optimized libc++ no_gmp arm64 windows
    ${cgal:+cgal_core})
fi
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$CMAKE_BUILD_PARALLEL_LEVEL}

# Optimization is low because the programs take far longer to compile than to run.
build_and_test()
{
  local build="$folder/$1"
  shift
  cmake -S "$root" -B "$build" -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DCMAKE_CXX_FLAGS_DEBUG=-O1 \
    -DPython3_EXECUTABLE=/usr/bin/python3 "$@" &&
    cmake --build "$build" &&
    ctest --test-dir "$build" --output-on-failure
}

build_and_test_processes()
{
  cmake -S "$root" -B "$folder/petsc" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O1 &&
    cmake --build "$folder/petsc" --target mpi_tests parameterize_mesh_file_mpi &&
    ctest --test-dir "$folder/petsc" --output-on-failure --tests-regex '^mpi_'
}

build_headers()
{
  for compiler in g++ clang++; do
    cmake -S "$root" -B "$folder/headers_$compiler" -DCMAKE_CXX_COMPILER="$compiler" &&
      cmake --build "$folder/headers_$compiler" --target headers || return 1
  done
}

# Compiles the core by COMPILER with FLAGS, and runs it by RUNNER. Headers of libraries are the same for all processors, but
# those of the system are not: only the former are shown to a cross compiler.
test_core() # NAME RUNNER COMPILER FLAGS...
{
  local build="$folder/$1" runner=$2 compiler=("${@:3}")
  local test="$root/test/Volume_mesh_parameterization" examples="$root/examples/Volume_mesh_parameterization"
  mkdir -p "$build/libraries"
  ln -sfn /usr/include/{CGAL,boost,eigen3,catch2} "$build/libraries"
  [ "$1" != cgal_core ] || ln -sfn "$cgal"/include/* "$build/libraries"
  compiler+=(-std=c++17 -O1 -DNDEBUG -DCGAL_EIGEN3_ENABLED -frounding-math -Wall -Wextra -I "$root/include" -I "$test"
    -isystem "$build/libraries" -isystem "$build/libraries/eigen3")
  local link=()
  [[ " ${compiler[*]} " == *DISABLE_GMP* ]] || link=(-lmpfr -lgmp)
  cp -r "$examples/data" "$build" &&
    "${compiler[@]}" "$examples/tetrahedron_soup.cpp" -o "$build/tetrahedron_soup.exe" "${link[@]}" &&
    (cd "$build" && $runner ./tetrahedron_soup.exe) &&
    "${compiler[@]}" "$test/test_entry_function.cpp" "$test/catch_main.cpp" -o "$build/test_entry_function.exe" "${link[@]}" &&
    (cd "$build" && $runner ./test_entry_function.exe) &&
    echo "100% tests passed, 0 tests failed out of 2"
}

# Checks all public headers in one unit with the CGAL given, by two standards, with and without what that CGAL deprecates.
check_headers_with_cgal()
{
  local unit="$folder/cgal_core/headers.cpp" standard deprecated
  (cd "$root/include" && find CGAL -name '*.h' | grep -vE '/(internal|license)/|Distributed|/Gmsh|/MSH|CHOLMOD' | sort |
    sed 's/.*/#include <&>/') > "$unit"
  for standard in 17 20; do
    for deprecated in -UCGAL_NO_DEPRECATED_CODE -DCGAL_NO_DEPRECATED_CODE; do
      "${CXX:-g++}" "-std=c++$standard" -fsyntax-only -Wall -Wextra -Wshadow -Wconversion -Werror "$deprecated" \
        -DCGAL_EIGEN3_ENABLED -frounding-math -I "$root/include" -isystem "$cgal/include" -isystem /usr/include/eigen3 \
        "$unit" || return 1
    done
  done
}

# Other configurations optimize less, and so do not see what compilers make of products of small matrices, and of one arithmetic
# for one thread and for many. The latter is tested with the engine, in a unit with fewer optimizations, and header-only.
test_optimized()
{
  local test="$root/test/Volume_mesh_parameterization" compiler level
  for compiler in g++ clang++; do
    for level in -O2 -O3; do
      local build="$folder/optimized/$compiler$level"
      local compile=("$compiler" -std=c++17 -march=native -DNDEBUG -DCGAL_EIGEN3_ENABLED -DCGAL_LINKED_WITH_TBB -frounding-math
        -I "$root/include" -I "$test" -isystem /usr/include/eigen3)
      cmake -S "$root" -B "$build" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS_RELEASE="$level -DNDEBUG" \
          -DCHOLMOD_LIBRARY=OFF &&
        cmake --build "$build" --target CGAL_Volume_mesh_parameterization_engine &&
        "${compile[@]}" -O1 -DCGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE "$test/fuzz_conditions.cpp" \
          -L "$build" -lCGAL_Volume_mesh_parameterization_engine -ltbb -lmpfr -lgmp -o "$build/fuzz_conditions" &&
        "$build/fuzz_conditions" 1000 &&
        "${compile[@]}" "$level" "$test/fuzz_conditions.cpp" -ltbb -lmpfr -lgmp -o "$build/fuzz_header_only" &&
        "$build/fuzz_header_only" 1000 &&
        "${compile[@]}" "$level" "$test/internal/test_dynamic_matrix.cpp" "$test/catch_main.cpp" -o "$build/test_dynamic_matrix" &&
        "$build/test_dynamic_matrix" || return 1
    done
  done
  echo "100% tests passed, 0 tests failed out of 12"
}

# Each reader is a name of one program, and reads files in memory. Its seeds, and what it finds, stay in FOLDER/fuzz.
fuzz_readers()
{
  local build="$folder/fuzz" reader
  local readers=(MEDIT VTU targets.{txt,csv,vtp} surface.{off,stl,obj} features conditions)
  mkdir -p "$build"
  clang++ -std=c++17 -O1 -g -DCGAL_EIGEN3_ENABLED -DCGAL_VOLUME_MESH_PARAMETERIZATION_USE_{ZLIB,LZMA,LZ4} -frounding-math \
    -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -I "$root/include" -isystem /usr/include/eigen3 \
    "$root/test/Volume_mesh_parameterization/fuzz_readers.cpp" -o "$build/fuzz_readers" -lmpfr -lgmp -lz -llzma -llz4 || return 1
  for reader in "${readers[@]}"; do
    ln -sfn fuzz_readers "$build/$reader"
    mkdir -p "$build/inputs_$reader"
    (cd "$build" && TMPDIR=/dev/shm "./$reader" "inputs_$reader" -max_total_time=120 -timeout=10 -print_final_stats=1) || return 1
  done
  echo "100% tests passed, 0 tests failed out of ${#readers[@]}"
}

# Prints the part of the lines of include/ that tests reach, by folder. The others are in FOLDER/coverage/untested.txt.
# Counters are mapped to files (%c), as processes that read files end without their exit handlers. Programs are asked one by
# one, as a function that one of them does not use hides its counts in another one.
measure_coverage()
{
  local build="$folder/coverage" status=0
  rm -rf "$build/profiles" "$build/untested.txt"
  CXXFLAGS="-fprofile-instr-generate -fcoverage-mapping -mllvm -runtime-counter-relocation -Wno-unused-command-line-argument" \
    LLVM_PROFILE_FILE="$build/profiles/%c%m.profraw" \
    build_and_test coverage -DCMAKE_CXX_COMPILER=clang++ || status=1
  llvm-profdata merge -sparse -o "$build/all.profdata" "$build"/profiles/*.profraw || return 1
  find "$build" -type f -executable ! -path '*CMakeFiles*' ! -path '*/installed*' |
    while read -r program; do
      [ "$(head -c 4 "$program" | tail -c 3)" != ELF ] ||
        llvm-cov export -format=lcov -instr-profile="$build/all.profdata" "$program"
    done |
    awk -v include="$root/include/CGAL/" -v untested="$build/untested.txt" '
      /^SF:/ { is_ours = index($0, include); file = substr($0, 4 + length(include)) }
      /^DA:/ && is_ours { split(substr($0, 4), number, ","); count[file ":" number[1]] += number[2] }
      END { for(line in count) { part = line
                                 sub(/\/?[^\/]*$/, "", part)
                                 ++lines[part]
                                 if(count[line] > 0) ++reached[part]; else print line > untested }
            for(part in lines) printf "%5.1f %% of %5d lines  %s\n", 100 * reached[part] / lines[part], lines[part], part }' |
    sort -k 6
  return "$status"
}

# Several threads are a program of their own.
test_threads()
{
  local test="$root/test/Volume_mesh_parameterization"
  mkdir -p "$folder/threads"
  clang++ -std=c++17 -O1 -g -DNDEBUG -DCGAL_EIGEN3_ENABLED -frounding-math -fsanitize=thread -I "$root/include" -I "$test" \
    -isystem /usr/include/eigen3 "$test/test_threads.cpp" "$test/catch_main.cpp" -o "$folder/threads/test_threads" -lmpfr -lgmp &&
    TSAN_OPTIONS=halt_on_error=1 "$folder/threads/test_threads" &&
    echo "100% tests passed, 0 tests failed out of 1"
}

run()
{
  case $1 in
    default) build_and_test "$1" ;;
    assertions) build_and_test "$1" -DCMAKE_BUILD_TYPE=Debug ;;
    library) build_and_test "$1" -DCMAKE_CXX_FLAGS=-D_GLIBCXX_ASSERTIONS ;;
    sanitizers) build_and_test "$1" -DCMAKE_CXX_COMPILER=clang++ \
                  "-DCMAKE_CXX_FLAGS=-fsanitize=address,undefined -fno-sanitize-recover=all" ;;
    fuzz) fuzz_readers ;;
    coverage) measure_coverage ;;
    threads) test_threads ;;
    clang) build_and_test "$1" -DCMAKE_CXX_COMPILER=clang++ ;;
    clang19) build_and_test "$1" -DCMAKE_CXX_COMPILER=clang++-19 ;;
    minimal) build_and_test "$1" -DCMAKE_CXX_STANDARD=20 -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON -DCHOLMOD_LIBRARY=OFF \
               -DZLIB_LIBRARY=OFF -DLZMA_LIBRARY=OFF -DLZ4_LIBRARY=OFF \
               -DGMSH_LIBRARY=OFF -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON \
               -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON ;;
    petsc) build_and_test_processes ;;
    cgal) CMAKE_PREFIX_PATH="$cgal" build_and_test "$1" ;;
    eigen) CMAKE_PREFIX_PATH="$eigen:$cgal" build_and_test "$1" ;;
    headers) build_headers ;;
    optimized) test_optimized ;;
    libc++) test_core "$1" "" clang++ -stdlib=libc++ ;;
    no_gmp) test_core "$1" "" g++ -DCGAL_DISABLE_GMP ;;
    arm64) test_core "$1" qemu-aarch64-static aarch64-linux-gnu-g++ -static -DCGAL_DISABLE_GMP ;;
    windows) WINEDEBUG=-all test_core "$1" /usr/lib/wine/wine64 x86_64-w64-mingw32-g++-posix -static -Wa,-mbig-obj -DCGAL_DISABLE_GMP ;;
    cgal_core) test_core "$1" "" "${CXX:-g++}" && check_headers_with_cgal ;;
    *) echo "there is no configuration '$1'"; return 1 ;;
  esac
}

"$root/scripts/install_dependencies.sh" clang clang-19 libclang-rt-dev llvm gmsh libgmsh-dev libvtk9-dev \
  meshio-tools python3-meshio tetgen libc++-dev libc++abi-dev g++-aarch64-linux-gnu \
  qemu-user-static g++-mingw-w64-x86-64-posix wine64
mkdir -p "$folder"
failures=0
for configuration in "${configurations[@]}"; do
  log="$folder/$configuration.log"
  result=passed
  if ! run "$configuration" > "$log" 2>&1; then
    result=FAILED
    failures=$((failures + 1))
  fi
  tests=$(sed -n 's/.*tests passed, .* tests failed out of \([0-9]*\)/\1 tests/p' "$log")
  echo "$configuration: $result, ${tests:-no tests}, $(grep -c 'warning: ' "$log" || true) warnings"
done
exit "$failures"
