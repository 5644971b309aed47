# Sourced by scripts/test: runs the parts, keeps their output, adds up what they passed and failed.
# shellcheck shell=bash

passed=0
failed=0
parts=()
part_ok=false
logs=build/test-logs

# part TITLE COUNTER COMMAND...: runs one part to its end, whatever happens in it, and sets part_ok.
# COUNTER reads the output and prints "PASSED FAILED". A part that fails without saying where counts as one failure, and
# so does a part of tests that ran none.
part() {
  local title=$1 counter=$2 status log good bad started=$SECONDS
  shift 2
  log=$logs/${title// /-}.log
  mkdir -p "$logs"
  printf '\n== %s\n' "$title"
  "$@" </dev/null 2>&1 | tee "$log"
  status=${PIPESTATUS[0]}
  read -r good bad < <("$counter" "$log" "$status")
  if ((status != 0 && bad == 0)); then bad=1; fi
  if [[ $counter != count_none ]] && ((good + bad == 0)); then bad=1; fi
  passed=$((passed + good))
  failed=$((failed + bad))
  if ((bad == 0)); then part_ok=true; else part_ok=false; fi
  parts+=("$(printf '%-7s %-20s %5d passed %4d failed %5d s' \
    "$($part_ok && echo ok || echo FAILED)" "$title" "$good" "$bad" $((SECONDS - started)))")
  if ! $part_ok; then
    while read -r line; do parts+=("        $line"); done < <(told_failures "$log")
    parts+=("        see $log")
  fi
}

# told_failures LOG: the first lines that tell of a failure: of ctest, of node, of a runner of our own, of a compiler. Only the end of
# the output may be at hand where nobody sees the logs.
told_failures() { grep -aE '\*\*\*|^(not ok|FAILED|✖)|error:|FAILED:$|^  (CHECK|REQUIRE)' "$1" | cut -c1-200 | head -n 30; }

# left_out TITLE REASON: a part that cannot run because an earlier one failed.
left_out() { parts+=("$(printf '%-7s %-20s %s' "not run" "$1" "$2")"); }

# A step that must work but is no test.
count_none() { echo 0 0; }

# One test: the exit status.
count_one() { if (($2 == 0)); then echo 1 0; else echo 0 1; fi; }

# ctest: "98% tests passed, 1 tests failed out of 50".
count_ctest() {
  sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests failed out of ([0-9]+).*/\1 \2/p' "$1" |
    awk '{ failed += $1; total += $2 } END { print total - failed, failed + 0 }'
}

# The test runner of node, "# pass 12" or "ℹ pass 12" and so on, once per run; a cancelled test is a failed one.
# A runner of our own closes with "12 passed, 0 failed".
count_node() {
  sed -E 's/\x1b\[[0-9;]*m//g' "$1" | awk '
    NF == 3 && $2 == "pass" { passed += $3 }
    NF == 3 && ($2 == "fail" || $2 == "cancelled") { failed += $3 }
    /^[0-9]+ passed, [0-9]+ failed$/ { passed += $1; failed += $3 }
    END { print passed + 0, failed + 0 }'
}

# close_report: the table of parts and the closing line; returns 1 when anything failed.
close_report() {
  printf '\n== parts\n'
  printf '%s\n' "${parts[@]}"
  printf '\n%d passed, %d failed\n' "$passed" "$failed"
  ((failed == 0))
}
