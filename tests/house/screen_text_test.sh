#!/usr/bin/env bash
# Texts of the window and the command line are plain: tools/plain flags none of their strings.
# Sentences have at most 15 words in the window and 25 on the command line. Usage:
# screen_text_test.sh SOURCE_DIR
set -euo pipefail
cd -- "$1"
command -v python3 >/dev/null || {
  echo 'skipped: python3 is not installed'
  exit 77
}
status=0
fail() {
  status=1
  printf '%s\n' "$*"
}

# Tests the check itself: adjacent literals are joined, comments and includes are ignored, long
# sentences and retired words are found.
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cat >"$work/good.cpp" <<'GOOD'
#include "beside/boundary words here.h"
const char* text = "Beside is a retired word in a comment only.";  // no: it is in the text
GOOD
cat >"$work/plain.cpp" <<'PLAIN'
// What stands beside the boundary is told by others.
const char* text = "Pixels are split only "  // in two parts
                   "where object edges cross them.";
PLAIN
cat >"$work/long.cpp" <<'LONG'
const char* text = "one two three four five six seven eight nine ten "
                   "eleven twelve thirteen fourteen fifteen sixteen";
LONG
tools/plain --strings 15 "$work/plain.cpp" >"$work/out" || fail "a plain string is flagged: $(<"$work/out")"
[[ $(<"$work/out") == '0 of 1 '* ]] || fail "neighbouring literals are not one: $(<"$work/out")"
! tools/plain --strings 15 "$work/good.cpp" >"$work/out" || fail 'a retired word passes'
! tools/plain --strings 15 "$work/long.cpp" >"$work/out" || fail 'a sentence of 16 words passes'

# strings_pass LEAST WORDS FILE...: no string is flagged, and at least LEAST sentences are found.
strings_pass() {
  local least=$1 words=$2 summary
  shift 2
  summary=$(tools/plain --strings "$words" "$@") || fail "$summary"
  read -r _ _ total _ < <(tail -n 1 <<<"$summary")
  ((total >= least)) || fail "only $total sentences found: this test looks wrong"
  tail -n 1 <<<"$summary"
}
shopt -s globstar
strings_pass 500 15 ui/**/*.cpp renderer/comparison/method.cpp renderer/lights/light_kinds.h
strings_pass 200 25 app/*.cpp app/report/report_command.cpp
exit $status
