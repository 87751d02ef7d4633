#!/usr/bin/env bash
# Installs the Debian packages that are needed and missing, those given as arguments among them. With --headers as the first
# argument, only those that a program needs.
set -euo pipefail

packages=(g++ make cmake libcgal-dev libboost-program-options-dev libeigen3-dev libsuitesparse-dev libopenblas0-serial
  libtbb-dev catch2 pkg-config libpetsc-real-dev libopenmpi-dev openmpi-bin zlib1g-dev liblzma-dev liblz4-dev "$@")
if [ "${1:-}" = --headers ]; then
  packages=(g++ libcgal-dev libeigen3-dev "${@:2}")
fi
models=/usr/share/doc/libcgal-dev/data.tar.gz # CGAL's models, in package libcgal-demo

missing=()
for package in "${packages[@]}"; do
  if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2> /dev/null)" != installed ]; then
    missing+=("$package")
  fi
done
if [ "${1:-}" != --headers ] && [ ! -e "$models" ]; then
  missing+=(libcgal-demo)
fi
if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi

echo "Installing ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  as_root=(sudo)
fi
# Runs apt-get. Waits up to ten minutes for other programs that have its locks, for one of which it has an option.
apt_get()
{
  local output attempt
  for attempt in {1..60}; do
    if output=$("${as_root[@]}" env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=600 "$@" 2>&1 |
                  tee >(cat >&2)); then
      return 0
    fi
    [[ $output == *"Could not get lock"* ]] || return 1
    sleep 10
  done
  return 1
}

apt_get update -o Acquire::Languages=none
# Slim systems leave out documentation, hence the models; reinstalling with this option brings them.
apt_get install -y --no-install-recommends --reinstall -o Dpkg::Options::=--path-include="$models" "${missing[@]}"
