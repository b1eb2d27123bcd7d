#!/usr/bin/env bash
# The progress bar is drawn and erased on a terminal, and never written to a file. script(1)
# provides the terminal. Usage: terminal_test.sh ASOS. Exit code 77: skipped, there is no script(1)
# or no pseudo-terminal.
set -uo pipefail
command -v script >/dev/null || {
  echo 'skipped: script(1) is not installed'
  exit 77
}
script -qec true /dev/null >/dev/null 2>&1 </dev/null || {
  echo 'skipped: script(1) cannot make a pseudo-terminal here'
  exit 77
}
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cd -- "$work" || exit 1
fail() {
  echo "$*"
  exit 1
}

render=(render builtin:boxes --size 640x360 --method stochastic --spp 16 --threads 1)
script -qec "'$1' ${render[*]} -o terminal.png" typescript >/dev/null ||
  fail "rendering on a terminal failed: $(cat typescript)"
grep -q '\[#*\.*\] *[0-9]* %' typescript || fail "no progress bar: $(cat -v typescript)"
grep -q 'Wrote terminal.png' typescript || fail "no closing line: $(cat -v typescript)"
"$1" "${render[@]}" -o file.png >out 2>err || fail "rendering into a file failed: $(cat err)"
[[ ! -s err ]] || fail "progress went into a file: $(cat -v err)"
script -qec "'$1' ${render[*]} -o quiet.png --quiet" quiet >/dev/null || fail 'quiet failed'
! grep -q '%\|Wrote' quiet || fail "--quiet was not quiet: $(cat -v quiet)"
echo 'progress only where it belongs'
