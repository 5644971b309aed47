# Sourced: installs node packages and builds web/, each only when something changed. Stamps live in node_modules.
# shellcheck shell=bash

# node_lock_hash FOLDER: of what decides which packages are installed there.
node_lock_hash() {
  { node --version && cat "$1/package-lock.json"; } | sha256sum
}

# web_source_hash: of everything that the built page is made from.
web_source_hash() {
  find web \( -path web/node_modules -o -path web/dist -o -path web/test -o -path web/e2e \) -prune -o -type f -print0 |
    sort -z | xargs -0 sha256sum | sha256sum
}

# web_tests_hash: of everything that the tests of the page without a browser read.
web_tests_hash() {
  find web examples docs \( -path web/node_modules -o -path web/dist \) -prune -o -type f -print0 |
    sort -z | xargs -0 sha256sum | sha256sum
}

# stamped FILE HASH: true when the step that wrote FILE last ran on the same content.
stamped() { [[ -f $1 && $(<"$1") == "$2" ]]; }

# node_install FOLDER: the packages of its lock file.
node_install() {
  local stamp=$1/node_modules/.dini-installed hash
  hash=$(node_lock_hash "$1") || return 1
  if stamped "$stamp" "$hash"; then return 0; fi
  npm --prefix "$1" ci --no-audit --no-fund --loglevel=error </dev/null && echo "$hash" >"$stamp"
}

web_build() {
  local stamp=web/node_modules/.dini-built hash
  node_install web || return 1
  hash=$(web_source_hash) || return 1
  if [[ -f web/dist/index.html ]] && stamped "$stamp" "$hash"; then return 0; fi
  npm --prefix web run --silent build </dev/null && echo "$hash" >"$stamp"
}

# web_lint: format and rules of the page's sources and tests; `npm --prefix web run format` mends what can be mended.
web_lint() {
  node_install web || return 1
  npm --prefix web run --silent lint </dev/null
}
