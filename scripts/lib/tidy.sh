# Sourced by scripts/test: clang-tidy on what changed, so that it stays short. scripts/lint checks everything.
# shellcheck shell=bash

source scripts/lib/cpp.sh

tidy_at_most=40

# tidy_base: the commit to compare with: DINI_TIDY_BASE, else where this branch left main, else, on main, the commit before.
tidy_base() {
  if [[ -n ${DINI_TIDY_BASE:-} ]]; then echo "$DINI_TIDY_BASE" && return; fi
  local main base head
  head=$(git rev-parse HEAD) || return 1
  for main in origin/main main; do
    base=$(git merge-base HEAD "$main" 2>/dev/null) && [[ $base != "$head" ]] && echo "$base" && return
  done
  git rev-parse HEAD^
}

# tidy_sources: the sources of the program that changed, and of each changed header one source that reads it.
tidy_sources() {
  local base file
  base=$(tidy_base) || return 1
  { git diff --name-only --diff-filter=d "$base" -- "${program_folders[@]}" &&
    git ls-files --others --exclude-standard -- "${program_folders[@]}"; } |
    while read -r file; do
      case $file in
        *.cpp) echo "$file" ;;
        *.h)
          if [[ -f ${file%.h}.cpp ]]; then echo "${file%.h}.cpp"; else
            grep -rlF --include='*.cpp' "\"$file\"" "${program_folders[@]}" | sort | head -n 1
          fi
          ;;
      esac
    done | sort -u
}

# tidy_changed: checks them, at most 40; says how many it left out.
tidy_changed() {
  local sources
  mapfile -t sources < <(tidy_sources)
  echo "${#sources[@]} sources to check"
  ((${#sources[@]} > 0)) || return 0
  if ((${#sources[@]} > tidy_at_most)); then
    echo "warning: only the first $tidy_at_most are checked, $((${#sources[@]} - tidy_at_most)) are left out; scripts/lint checks all"
    sources=("${sources[@]:0:tidy_at_most}")
  fi
  cmake --preset tidy >/dev/null || return 1
  printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy-14 --quiet -p build/tidy
}
