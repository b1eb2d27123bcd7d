#!/usr/bin/env bash
# Pipes and devices are written to and not replaced; output that cannot be written is an error.
# Usage: outputs_test.sh ASOS
set -uo pipefail
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cd -- "$work" || exit 1
fail() {
  echo "$*"
  exit 1
}
render=("$1" render builtin:boxes --size 16x12)

# Written to a pipe the picture is the same as in a file.
for ending in png exr; do
  "${render[@]}" -o "plain.$ending" --crop 0,0,4,4 --quiet || fail "no plain $ending"
  mkfifo "pipe.$ending"
  timeout 20 cat "pipe.$ending" >"through.$ending" &
  reader=$!
  timeout 20 "${render[@]}" -o "pipe.$ending" --crop 0,0,4,4 --quiet || fail "no $ending to a pipe"
  wait "$reader" || fail "nothing came through pipe.$ending"
  [[ -p pipe.$ending ]] || fail "pipe.$ending was replaced"
  [[ $(head -c 4 "through.$ending" | od -c) == $(head -c 4 "plain.$ending" | od -c) ]] ||
    fail "no $ending came through: $(wc -c <"through.$ending") bytes"
done
mkfifo pipe.glb
timeout 20 cat pipe.glb >through.glb &
reader=$!
timeout 20 "$1" export-scene boxes -o pipe.glb >/dev/null || fail 'no scene to a pipe'
wait "$reader" && [[ -p pipe.glb && $(head -c 4 through.glb) == glTF ]] || fail 'no scene came through'

ln -s /dev/full full.png
ln -s /dev/null null.png
"${render[@]}" -o null.png --quiet || fail 'no picture to a device'
"${render[@]}" -o full.png 2>err && fail 'a full device took a picture'
grep -q 'No space left' err || fail "a full device: $(cat err)"
[[ -L full.png && -L null.png && -c /dev/null ]] || fail 'a link to a device was replaced'

# Answers
for words in 'info builtin:boxes' 'info builtin:boxes --json' '--help' 'list-scenes' \
  'trace builtin:boxes --size 16x12 --pixel 8,6'; do
  # shellcheck disable=SC2086
  "$1" $words >/dev/full 2>err
  status=$?
  ((status == 1)) || fail "$words >/dev/full: exit code $status"
  grep -q 'cannot be written' err || fail "$words >/dev/full: $(cat err)"
done

echo 'outputs are written through, and what cannot be written is told'
