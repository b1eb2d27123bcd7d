#!/usr/bin/env bash
# SIGINT and SIGTERM end the program within a second while it loads, even if a library never returns
# from reading the file. Usage: abandon_test.sh ASOS STUCK_READ
set -uo pipefail
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cd -- "$work" || exit 1
fail() {
  echo "$*"
  exit 1
}

set -m # gives background jobs a SIGINT of their own
echo '{"asset":{"version":"2.0"}}' >stuck.gltf
printf '#?RADIANCE\n' >stuck.hdr
printf 'before' >kept.png

# expect SIGNAL WORDS ARGUMENT...
expect() {
  local signal=$1 words=$2 began status
  shift 2
  rm -f begun
  LD_PRELOAD=$stuck "$asos" "$@" >out 2>err &
  local job=$!
  for _ in $(seq 400); do
    [[ -e begun ]] && break
    sleep 0.05
  done
  kill -0 "$job" 2>/dev/null || fail "$*: it ended by itself: $(cat err)"
  began=$(date +%s%N)
  kill "-$signal" "$job"
  { sleep 10; kill -KILL "$job"; } 2>/dev/null &
  local last=$!
  wait "$job"
  status=$?
  { kill -KILL -- "-$last" && wait "$last"; } 2>/dev/null # its sleep, too
  ((($(date +%s%N) - began) / 1000000 <= 1000)) || fail "$*: $signal ended it after a second"
  ((status == 130)) || fail "$*: $signal: exit code $status instead of 130: $(cat err)"
  grep -qF "$words" err || fail "$*: $signal: said only: $(cat err)"
  [[ $(cat kept.png) == before ]] || fail "$*: the old picture was touched"
  [[ -z $(find . -name '*part*') ]] || fail "$*: files were left behind: $(find .)"
}

asos=$1
stuck=$2
for signal in INT TERM; do
  expect "$signal" 'nothing was written' render stuck.gltf -o kept.png
  expect "$signal" 'nothing was written' render builtin:boxes --sky stuck.hdr -o kept.png
  expect "$signal" 'no report was written' report stuck.gltf -o report --job 0
done
echo 'given up within a second'
