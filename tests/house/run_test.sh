#!/usr/bin/env bash
# ./run works from another folder and with spaces in paths. Without a display it renders to a PNG in
# the current directory and prints its path; subcommands and exit codes are passed through.
# Usage: run_test.sh SOURCE_DIR
set -uo pipefail
run=$1/run
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
mkdir "$work/a folder"
cd -- "$work/a folder" || exit 1
unset DISPLAY WAYLAND_DISPLAY
fail() {
  echo "$*"
  exit 1
}

output=$("$run" builtin:boxes --size 64x36 2>&1) || fail "it failed: $output"
[[ $(file -b -- boxes.png 2>/dev/null || head -c 4 boxes.png) == *PNG* ]] || fail 'no boxes.png'
[[ $output == *"$PWD/boxes.png"* ]] || fail "it did not say where: $output"

"$run" export-scene boxes -o 'some boxes.glb' >/dev/null || fail 'export-scene did not pass through'
ln -s -- "$run" 'linked run'
output=$('./linked run' 'some boxes.glb' --size 64x36 2>&1) || fail "it failed: $output"
[[ -s 'some boxes.png' ]] || fail "no picture of a scene with a space in its name: $output"

"$run" 'no such.glb' >/dev/null 2>&1
status=$?
((status == 1)) || fail "exit code $status for a missing scene"
"$run" builtin:boxes --max 99 >/dev/null 2>&1
status=$?
((status == 2)) || fail "exit code $status for a bad option"
echo 'run works'
