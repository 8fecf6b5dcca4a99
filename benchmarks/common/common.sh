# shellcheck shell=sh
# Sourced by the run scripts of the rooms, which stand in the project's folder: Python, a build folder
# of their own, where the results of this machine go, and the heading of a table.

python=/usr/bin/python3
[ -x "$python" ] || python=python3
build="build-benchmarks"

from_cpuinfo() { sed -n "s/^$1[[:space:]]*: //p" /proc/cpuinfo | head -n 1; }
processor=$(from_cpuinfo 'model name')
family=$(from_cpuinfo 'cpu family')
model=$(from_cpuinfo 'model')
slug() { printf %s "$1" | tr '[:upper:]' '[:lower:]' | tr -cs 'a-z0-9.' _ | sed 's/^_*//; s/_*$//'; }

# build_benchmark TARGET
build_benchmark() {
  cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DABUT_BUILD_BENCHMARKS=ON \
    -DABUT_BUILD_TOOL=OFF -DABUT_BUILD_EXAMPLES=OFF -DABUT_BUILD_TESTS=OFF -DABUT_INSTALL=OFF >&2
  cmake --build "$build" --target "$1" >&2
  compiler=$(sed -n 's/^set(CMAKE_CXX_COMPILER_ID "\(.*\)")$/\1/p; s/^set(CMAKE_CXX_COMPILER_VERSION "\(.*\)")$/\1/p' \
    "$build"/CMakeFiles/*/CMakeCXXCompiler.cmake | paste -s -d ' ')
}

# results_folder [MACHINE]: named after the processor, or as said. The model belongs to the name, since
# virtual machines call processors of several generations the same.
results_folder() {
  echo "benchmarks/results/$(slug "${1:-$processor${family:+ family $family model $model}}")_$(slug "$compiler")"
}

# record TABLE COMMAND...: what the command prints, once it has all of it, under a heading. What a
# command printed that failed stays in TABLE.unfinished.
record() {
  table=$1
  shift
  mkdir -p "$(dirname "$table")"
  {
    echo "# processor: ${processor:-$(uname -m)}${family:+ (family $family, model $model)}, $(nproc) cores"
    echo "# compiler: $compiler, Release"
    echo "# date: $(date -u +%Y-%m-%d)"
    echo "# commit: $(git rev-parse --short HEAD)$(git diff --quiet HEAD -- src include scenes || echo ' and changes')"
    "$@"
  } > "$table.unfinished" || return
  mv "$table.unfinished" "$table"
}
