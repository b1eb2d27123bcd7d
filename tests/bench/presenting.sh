#!/usr/bin/env bash
# Cost of displaying the picture, in percent of one core: CPU time of all threads of the real window
# except the rendering ones, while tiles arrive and when it is idle. Uses a virtual screen with
# software OpenGL, the most expensive case.
# Usage: presenting.sh ASOS_PROGRAM [SECONDS]
set -euo pipefail
program=$1
seconds=${2:-8}
work=$(mktemp -d)
app= xvfb=
trap 'kill $app $xvfb 2>/dev/null || true; rm -rf -- "$work"' EXIT
exec 3>"$work/display"
Xvfb -displayfd 3 -screen 0 1680x900x24 -nolisten tcp >/dev/null 2>&1 &
xvfb=$!
exec 3>&-
while [[ ! -s $work/display ]]; do sleep 0.1; done
export DISPLAY=:$(cat "$work/display") LIBGL_ALWAYS_SOFTWARE=1 XDG_CONFIG_HOME=$work

# CPU ticks of all threads of the program except the rendering ones.
ticks() {
  local total=0 thread stat
  for thread in /proc/"$app"/task/*; do
    [[ $(cat "$thread/comm" 2>/dev/null) != 'asos render' ]] || continue
    read -ra stat < <(sed 's/.*) //' "$thread/stat" 2>/dev/null) || continue
    total=$((total + stat[11] + stat[12]))
  done
  echo "$total"
}
measure() {
  local before after
  before=$(ticks)
  sleep "$seconds"
  after=$(ticks)
  printf '%-28s %5.1f %% of a core\n' "$1" \
    "$(awk -v t=$((after - before)) -v hz="$(getconf CLK_TCK)" -v s="$seconds" \
      'BEGIN { print 100 * t / hz / s }')"
}
renders() { grep -qx 'asos render' /proc/"$app"/task/*/comm 2>/dev/null; }
start() {
  "$program" "$@" >/dev/null 2>&1 &
  app=$!
  until xdotool search --onlyvisible --class asos >/dev/null 2>&1; do sleep 0.2; done
  sleep 3
}

start builtin:office --max 8 --eps 0 --threads 1
measure 'while tiles arrive (office)'
renders || echo 'the render ended meanwhile'
kill "$app"
wait "$app" 2>/dev/null || true
start builtin:boxes --method uniform --spp 1 --size 640x360
while renders; do sleep 0.5; done
sleep 5
measure 'idle (boxes, finished)'
