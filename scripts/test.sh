#!/usr/bin/env bash
# Installs what is missing, builds everything in build/test_suite/ and runs all tests. Optimization is low because the
# programs take far longer to compile than to run, and tests are compiled in groups.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$root/build/test_suite"
jobs=$(nproc)

"$root/scripts/install_dependencies.sh"
cmake -S "$root" -B "$build" -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
  -DCGAL_Volume_mesh_parameterization_TESTS_IN_GROUPS=ON
cmake --build "$build" --parallel "$jobs"
ctest --test-dir "$build" --output-on-failure --parallel "$jobs"
