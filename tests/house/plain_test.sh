#!/usr/bin/env bash
# Comments are plain: tools/plain flags at most the share below of each folder's sentences, and each
# flagged sentence has a line in plain_waivers.txt, which is read at review.
# Usage: plain_test.sh SOURCE_DIR. Exit code 77: skipped, python3 is not installed.
set -euo pipefail
cd -- "$1"
command -v python3 >/dev/null || {
  echo 'skipped: python3 is not installed'
  exit 77
}

# Folder and largest share of flagged sentences, in percent.
limits=(renderer=3 ui=3 app=3 tests=3)

# The check itself, on a folder with one plain and one odd comment.
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
mkdir "$work/code"
cat >"$work/code/a.h" <<'CODE'
/// Returns the sum of the areas of all visible parts.
double area();
/// Of what is told beside the others, which is what it stands for, so many are held.
double odd();
CODE
touch "$work/none.txt"
printf '%s\n' '# the reason' "$work/code/a.h: Of what is told beside the others, which" >"$work/one.txt"
cp "$work/one.txt" "$work/two.txt"
printf '%s\n' "$work/code/a.h: Of what there is" >>"$work/two.txt"
status=0
# expect RESULT WAIVERS LIMIT: whether the check of the folder passes (0) or fails (1).
expect() {
  local result=0
  tools/plain --check "$work/$2" "$work/code=$3" >"$work/log" || result=1
  ((result == $1)) || {
    status=1
    printf 'tools/plain --check returns %d with %s and limit %s:\n' "$result" "$2" "$3"
    cat "$work/log"
  }
}
expect 0 one.txt 50
expect 1 one.txt 49
expect 1 none.txt 50
expect 1 two.txt 50

tools/plain --check tests/house/plain_waivers.txt "${limits[@]}" || status=1
exit $status
