#!/usr/bin/env bash
# Installs what is missing, builds everything in build/ and runs all tests.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=$(nproc)

"$root/scripts/install_dependencies.sh"
cmake -S "$root" -B "$root/build"
cmake --build "$root/build" --parallel "$jobs"
ctest --test-dir "$root/build" --output-on-failure --parallel "$jobs"
