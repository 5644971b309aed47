# Sourced: the C++ builds.
# shellcheck shell=bash

# cpp_build PRESET [TARGET...]: configures when the preset is new or changed, then builds as much as can be built.
cpp_build() {
  local preset=$1 target targets=()
  shift
  for target in "$@"; do targets+=(--target "$target"); done
  if [[ ! -f build/$preset/build.ninja || CMakePresets.json -nt build/$preset/build.ninja ]]; then
    cmake --preset "$preset" || return 1
    touch "build/$preset/build.ninja"
  fi
  cmake --build --preset "$preset" "${targets[@]}" -- -k 0
}

# The folders of the program; those of its tests and benchmarks stand beside them.
program_folders=(algebra geometry draco gltf formats graph golden nodes fitting service store jobs queue server cli)

# cpp_sources: every C++ file of the project, NUL-separated; what npm installs below tests/ is not ours.
cpp_sources() { find "${program_folders[@]}" tests bench -name node_modules -prune -o \( -name '*.h' -o -name '*.cpp' \) -print0 | sort -z; }
