#!/usr/bin/env bash
# SIGINT stops a long render quickly with exit code 130. It leaves no new files, complete or
# partial, and existing files stay. With --time-limit it writes the best picture so far, marked as
# unfinished. Usage: interrupt_test.sh ASOS
set -uo pipefail
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cd -- "$work" || exit 1
fail() {
  echo "$*"
  exit 1
}

printf 'before' >kept.png
# With job control a background job receives SIGINT; without it the shell makes the job ignore it.
set -m
"$1" render builtin:boxes -o kept.png --stats new.json --size 4096x4096 --method stochastic \
  --spp 4096 --threads 2 >out 2>err &
job=$!
sleep 2
kill -0 "$job" 2>/dev/null || fail "the render ended before it could be interrupted: $(cat err)"
kill -INT "$job"
started=$SECONDS
wait "$job"
status=$?
((status == 130)) || fail "exit code $status instead of 130: $(cat err)"
((SECONDS - started <= 30)) || fail "stopping took $((SECONDS - started)) s"
[[ $(cat kept.png) == before ]] || fail 'the old picture was touched'
files=$(find . -type f | sort | tr '\n' ' ')
[[ $files == './err ./kept.png ./out ' ]] || fail "files were left behind: $files"
grep -q interrupted err || fail "nothing was said about it: $(cat err)"

"$1" render builtin:boxes -o best.png --stats best.json --size 1024x1024 --method stochastic \
  --spp 4096 --threads 2 --time-limit 3600 >out 2>err &
job=$!
sleep 2
kill -0 "$job" 2>/dev/null || fail "the render ended before it could be interrupted: $(cat err)"
kill -INT "$job"
wait "$job"
status=$?
((status == 130)) || fail "exit code $status instead of 130 with a time limit: $(cat err)"
[[ -s best.png && -s best.json ]] || fail "the best picture so far was not written: $(cat err)"
grep -q unfinished err || fail "nothing was said about the unfinished picture: $(cat err)"
grep -q '"finished": *false' best.json || fail "the picture is not marked: $(cat best.json)"
grep -q '"interrupted": *true' best.json || fail "the interrupt is not noted: $(cat best.json)"
echo 'interrupted cleanly'
