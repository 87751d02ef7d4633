#!/usr/bin/env bash
# Installs what is missing, builds everything in build/test_suite/ and runs all tests, by the compiler in $CXX. Programs take
# far longer to compile than to run. Therefore, the default compiler is clang++, which needs half the time of g++ without
# optimization. Its linker needs a third of the time of the usual one. Ninja has work for all processors until the end. If the
# kernel permits it, large pages make compilers faster by an eighth to a fifth.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$root/build/test_suite"
jobs=$(nproc)
jobs_by_memory=$(awk '/^MemAvailable/ { print int($2 / 2e6) + 1 }' /proc/meminfo) # a compiler takes up to 2 GB
if [ "$jobs_by_memory" -lt "$jobs" ]; then
  jobs=$jobs_by_memory
fi

"$root/scripts/install_dependencies.sh" clang libclang-rt-dev lld ninja-build
export CXX="${CXX:-clang++}" GLIBC_TUNABLES=glibc.malloc.hugetlb=1
if ! grep -qs '^CMAKE_GENERATOR:INTERNAL=Ninja$' "$build/CMakeCache.txt"; then
  rm -rf "$build" # another generator has built there
fi
cmake -G Ninja -S "$root" -B "$build" -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" \
  -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld -DCGAL_Volume_mesh_parameterization_COMPILE_FAST=ON
cmake --build "$build" --parallel "$jobs"
ctest --test-dir "$build" --output-on-failure --parallel "$jobs"
