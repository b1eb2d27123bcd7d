#!/usr/bin/env bash
# Makes every system call that writes a command's files fail once, as on full and broken disks. The
# command must end with exit code 1 and name a file. Existing files stay or are replaced completely,
# and no other files are left. Usage: faults_test.sh ASOS FAIL_CALL. Exit code 77: skipped, calls
# cannot be made to fail on this system.
set -uo pipefail
asos=$1
fail_call=$2
work=$(realpath -- "$(mktemp -d)")
trap 'rm -rf -- "$work"' EXIT
cd -- "$work" || exit 1
printf 'old' >old
failed=0
ran=0
fault() {
  failed=$((failed + 1))
  echo "$*"
}


# attempt N FAULT ARGUMENT...: runs the program with old files in out/; sets `code` and `calls`.
attempt() {
  local n=$1 how=$2
  shift 2
  rm -rf -- "$work/out"
  mkdir -- "$work/out"
  local file
  for file in "${outputs[@]}"; do cp old "out/$file"; done
  timeout 60 "$fail_call" "$n" "$how" "$work/out" "$asos" "$@" 9>calls >said 2>err </dev/null
  code=$?
  ran=$((ran + 1))
}

# whole FILE: whether the file is complete.
whole() {
  case $1 in
    *.png) [[ $(tail -c 8 "$1" | head -c 4) == IEND ]] ;;
    *.exr) [[ $(wc -c <"$1") -eq $(wc -c <"new/${1##*/}") ]] ||
      "$asos" render --from "$1" -o again.png --quiet >/dev/null 2>&1 ;;
    *.json) [[ $(tail -c 2 "$1" | tr -d '\n') == '}' ]] ;;
    *.html) grep -q '</html>' "$1" ;;
    # The number of lines depends on the time that the renders take.
    */progress.csv) [[ $(tail -c 1 "$1" | wc -l) == 1 ]] &&
      tail -n 1 "$1" | grep -qE '^builtin:boxes,sobol,256 spp,[0-9]+,[0-9.]+,[0-9.]+e[-+][0-9]+$' ;;
    *.csv) [[ $(wc -l <"$1") == "$(wc -l <"new/${1##*/}")" ]] ;;
    *) cmp -s "$1" "new/${1##*/}" ;;
  esac
}

# judge CALL ARGUMENT...: checks how a run with a failed call ended.
judge() {
  local call=$1 file
  shift
  ((code == 1)) || fault "$call: exit code $code: $*: $(head -c 300 err)"
  local named=0
  for file in "${outputs[@]}"; do
    if grep -qE -- "$file|out/(jobs|plots|pictures)/" err; then named=1; fi
    if cmp -s "out/$file" old; then continue; fi
    if [[ ! -e out/$file ]] || ! whole "out/$file"; then fault "$call: left $file neither old nor new: $*"; fi
  done
  ((named)) || fault "$call: named no file: $*: $(head -c 300 err)"
  file=$(find out -name '.*' -not -name out -print -quit)
  [[ -z $file ]] || fault "$call: left $file behind: $*"
}

# each STEP ARGUMENT...: fails every STEP-th call of a command, with each fault.
each() {
  local step=$1 n call how
  shift
  attempt 0 EIO "$@"
  ((code != 77)) || {
    echo 'skipped: the system lets no call fail on demand'
    exit 77
  }
  ((code == 0)) || fault "without a fault: exit code $code: $*: $(cat err)"
  rm -rf new
  cp -r out new
  local -a made
  mapfile -t made <calls
  ((${#made[@]} >= 4)) || fault "only ${#made[@]} calls seen: $*"
  for ((n = 1; n <= ${#made[@]}; n += step)); do
    for how in "${ways[@]}"; do
      [[ $how != short || ${made[n - 1]} == write* ]] || continue
      attempt "$n" "$how" "$@"
      # The number of a call differs between runs: a report's jobs depend on time.
      call=$(sed -n "$n"p calls)
      # gnuplot reports no single fault, only a disk that stays full.
      [[ $how == short || $call != */plots/*.[slp][von]g ]] || continue
      [[ -n $call ]] || continue
      # There was no write after that call, so none was truncated.
      [[ $how != short ]] || tail -n +"$n" calls | grep -q '^write ' || continue
      judge "call $n, $call, $how" "$@"
    done
  done
}

ways=(ENOSPC EIO short)
small=(--size 12x8 --max 1 --threads 1)
outputs=(p.png m.png s.json)
each 1 render builtin:boxes "${small[@]}" -o out/p.png --split-map out/m.png --stats out/s.json
outputs=(p.exr)
each 1 render builtin:boxes "${small[@]}" -o out/p.exr --quiet
outputs=(turn-0.png turn-1.png)
each 2 render builtin:boxes "${small[@]}" -o out/turn.png --frames 0-1/2
outputs=(b.glb)
each 1 export-scene boxes -o out/b.glb
outputs=(b.gltf)
each 1 export-scene boxes -o out/b.gltf
# A report has about a hundred files and takes a second.
outputs=(report.html report.json points.csv progress.csv)
ways=(EIO short)
each 17 report builtin:boxes -o out --size 12x8 --methods asos,sobol --repetitions 1 --budget 0.05

((failed == 0)) || {
  echo "$failed faults in $ran runs"
  exit 1
}
echo "$ran runs without a fault"
