#!/usr/bin/env bash
# Every file of the shared corpora of broken, odd and hostile files is reported and rendered, or
# rejected with an error. No abort, signal, hang or silence; no output that a terminal would
# execute. A rejection takes at most a second. Memory is at most 300 MB plus three times the size of
# the files read. Usage: corpus_test.sh ASOS MEASURED SHARED; ASOS_SHARED overrides SHARED. Exit
# code 77: skipped, there are no such files. ASOS_SLOWDOWN: factor of time that this build may take.
# ASOS_MEMORY_PERCENT: memory of this build in percent of a normal one's, for sanitizers.
set -uo pipefail
asos=$1
measured=$2
shared=${ASOS_SHARED:-$3}
[[ -d $shared/hostile && -d $shared/bad && -d $shared/odd ]] || {
  echo "skipped: $shared has no hostile, bad and odd files"
  exit 77
}
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
slowdown=${ASOS_SLOWDOWN:-1}
longest_s=$((60 * slowdown)) # of processor time, of anything
stuck_s=$((8 * longest_s)) # by the clock: the machine may be busy with other work
refusal_ms=$((1000 * slowdown)) # of processor time
most_kb=300000
percent=${ASOS_MEMORY_PERCENT:-100}
failed=0
ran=0
fault() {
  failed=$((failed + 1))
  echo "$*"
}

# run NAME KB ARGUMENT...: runs the program, checks how it ended and sets `code`. KB: size of its
# input files.
run() {
  local name=$1 read_kb=$2 cpu_ms used_kb
  shift 2
  (
    ulimit -t "$longest_s"
    exec "$measured" timeout --signal=KILL "$stuck_s" "$asos" "$@"
  ) 9>"$work/measures" >"$work/out" 2>"$work/err" </dev/null
  code=$?
  read -r cpu_ms used_kb <"$work/measures"
  ran=$((ran + 1))
  case $code in
    0) ;;
    1)
      [[ -s $work/err ]] || fault "$name: refused without a word: $*"
      ((cpu_ms <= refusal_ms)) || fault "$name: refused after $cpu_ms ms: $*"
      ;;
    *) fault "$name: ended with $code: $* ($(head -c 300 "$work/err" | cat -v))" ;;
  esac
  ((used_kb * 100 <= (3 * read_kb + most_kb) * percent)) || fault "$name: took $used_kb kB for a file of $read_kb kB: $*"
  # Except for newlines: no bytes below a space, no 0x7f, and valid UTF-8.
  if LC_ALL=C grep -qP '[\x00-\x08\x0b-\x1f\x7f]' "$work/out" "$work/err" ||
    ! iconv -f UTF-8 -t UTF-8 "$work/out" "$work/err" >/dev/null 2>&1; then
    fault "$name: printed what a terminal obeys: $*"
  fi
  if grep -q '^asos: all fine' "$work/out" "$work/err"; then fault "$name: forged a line: $*"; fi
}

# expect FILE CODE WORDS: checks the exit code and the message of a file's last run.
expect() {
  ((code == $2)) || fault "$1: ended with $code instead of $2"
  grep -qF -- "$3" "$work/out" "$work/err" || fault "$1: did not say '$3'"
}

render=(--size 16x12 --max 2 -o "$work/picture.png")
while IFS= read -r -d '' file; do
  name=${file#"$shared"/}
  # Includes the files next to it, which the program may also read.
  kb=$(du -Lsk -- "$file" | cut -f1)
  [[ $name != *.gltf ]] || kb=$(du -Lsk -- "$(dirname -- "$file")" | cut -f1)
  run "$name" "$kb" info "$file"
  told=$code
  said_by_info=$(grep -c '^Warning: ' "$work/out")
  run "$name" "$kb" render "$file" "${render[@]}" --allow-empty
  ((code == told)) || fault "$name: info ends with $told, render with $code"
  # Warnings of info also appear in render.
  if ((code == 0 && said_by_info > 0)); then
    grep -q '^asos: warning: ' "$work/err" || fault "$name: rendered without a word"
  fi
  case $name in
    hostile/triangle-*) expect "$name" 1 'the limit is' ;;
    hostile/camera-at-*) expect "$name" 0 'farther away' ;;
    hostile/half-missing.gltf) expect "$name" 0 'buffer' ;;
    hostile/escape-in-required-*) expect "$name" 1 '\x1b' ;;
    hostile/two-instances-*) expect "$name" 0 'Wrote' ;;
  esac
done < <(find -L "$shared/hostile" "$shared/bad" "$shared/odd" \
  \( -name '*.gltf' -o -name '*.glb' \) -type f -print0 | sort -z)
while IFS= read -r -d '' file; do
  run "${file#"$shared"/}" 1 render --from "$file" -o "$work/picture.png"
  expect "$file" 1 'farther away'
done < <(find "$shared/hostile" \( -name '*.exr' -o -name '*.png' \) -print0)
while IFS= read -r -d '' file; do
  run "${file#"$shared"/}" 1 render builtin:boxes --sky "$file" "${render[@]}"
  expect "$file" 1 'picture cannot be read'
done < <(find "$shared/hostile" -name '*.hdr' -print0)

((ran >= 100)) || fault "only $ran runs: this test looks in the wrong place"
((failed == 0)) || {
  echo "$failed faults in $ran runs"
  exit 1
}
echo "$ran runs without a fault"
