# Sourced by scripts/test: holds two builds of the program against each other.
# shellcheck shell=bash

# same_files PROGRAM OTHER: every example evaluated by both; a file that differs, or is not written, is a failure.
same_files() {
  local folder example name good=0 bad=0
  folder=$(mktemp -d) || return 1
  for example in examples/*.json; do
    name=$(basename "$example" .json)
    if "$1" eval "$example" --out "$folder/one.glb" >/dev/null && "$2" eval "$example" --out "$folder/other.glb" >/dev/null &&
      cmp "$folder/one.glb" "$folder/other.glb"; then
      good=$((good + 1))
    else
      echo "$name differs between $1 and $2, or was not written" >&2
      bad=$((bad + 1))
    fi
    rm -f "$folder"/*.glb
  done
  rm -rf "$folder"
  echo "$good passed, $bad failed"
  ((bad == 0))
}
