# Sourced: the check of the scripts themselves.
# shellcheck shell=bash

# shell_lint: shellcheck on every script.
shell_lint() {
  local scripts
  mapfile -t scripts < <(grep -lE '^#!.*(bash|/sh$)|shellcheck shell=bash' scripts/* scripts/lib/*.sh docker/* .ci/* 2>/dev/null)
  shellcheck "${scripts[@]}"
}
