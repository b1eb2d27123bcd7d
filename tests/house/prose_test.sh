#!/usr/bin/env bash
# README.md is short, and the documents are plain: tools/plain flags at most 3 % of their sentences.
# Usage: prose_test.sh SOURCE_DIR
set -euo pipefail
cd -- "$1"
status=0
fail() {
  status=1
  printf '%s\n' "$*"
}
command -v python3 >/dev/null || {
  echo 'skipped: python3 is not installed'
  exit 77
}

lines=$(wc -l <README.md)
((lines <= 150)) || fail "README.md has $lines lines, of at most 150"

# Tests the check itself with a plain and an odd sentence.
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
printf 'The dialog filters the folder and the recent files as you type.\n' >"$work/plain.md"
printf 'Of what is told beside the others, which is what it stands for, so many are held.\n' >"$work/odd.md"
[[ $(tools/plain --share "$work/plain.md") == '0 of 1 '* ]] || fail 'tools/plain flags a plain sentence'
[[ $(tools/plain --share "$work/odd.md") == '1 of 1 '* ]] || fail 'tools/plain passes an odd sentence'

documents=(README.md CONTRIBUTING.md CHANGELOG.md packaging/THIRD-PARTY.md docs)
read -r flagged _ total _ < <(tools/plain --share "${documents[@]}")
((total >= 500)) || fail "only $total sentences found: this test looks wrong"
((100 * flagged <= 3 * total)) || {
  tools/plain "${documents[@]}"
  fail "$flagged of $total sentences are hard to read; at most 3 % are allowed"
}
((status == 0)) && echo "$flagged of $total sentences flagged, README.md has $lines lines"
exit $status
