# shellcheck shell=bash
# Sourced by the scripts beside it: where the project lies, how to talk, how many jobs fit.
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1

say() { printf '\n== %s\n' "$*" >&2; }
fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# Compile jobs: one a processor, but 1.5 GiB of free memory for each (CGAL and RapidCheck want it).
jobs() {
  local processors available
  processors=$(nproc)
  available=$(awk '/^MemAvailable:/ { print int($2 / 1572864) }' /proc/meminfo)
  ((available < 1)) && available=1
  ((available < processors)) && processors=$available
  echo "$processors"
}

# configure FOLDER CMAKE_OPTIONS...: a build folder for Ninja, or whatever an existing one uses.
configure() {
  local folder=$1
  shift
  [[ -f $folder/CMakeCache.txt ]] || set -- -G Ninja "$@"
  if command -v ccache >/dev/null; then
    set -- -DCMAKE_CXX_COMPILER_LAUNCHER=ccache "$@"
  fi
  cmake -S . -B "$folder" "$@"
}

# build FOLDER [CMAKE_BUILD_OPTIONS...]
build() {
  local folder=$1
  shift
  cmake --build "$folder" --parallel "$(jobs)" "$@"
}
