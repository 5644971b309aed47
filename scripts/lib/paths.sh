# Sourced by every script: moves to the root of the repository and names it.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root" || exit 1

# takes_no_words WORD...: ends a script that is given words it would pass over.
takes_no_words() {
  (($# == 0)) && return
  echo "$(basename "$0"): takes no words, but was given: $*" >&2
  exit 2
}
