#!/usr/bin/env bash
# Runs the real window on a virtual screen and uses it as a person would: waits for the picture,
# drags EPS, undoes that, clicks a pixel, orbits, resizes, takes a screenshot, opens a file that does
# not exist and one that does (where the shared scenes are there), quits. Pictures of the screen stay
# in the current directory for a look.
#
# usage: window_test.sh ASOS_PROGRAM [SCENE]
set -u
program=$1
scene=${2:-builtin:boxes}
skip=77

for tool in Xvfb xdotool import convert; do
  if ! command -v "$tool" >/dev/null; then
    echo "skipped: $tool is not installed"
    exit $skip
  fi
done

work=$(mktemp -d)
xvfb= app=
clean_up() {
  [ -n "$app" ] && kill "$app" 2>/dev/null
  [ -n "$xvfb" ] && kill "$xvfb" 2>/dev/null
  wait 2>/dev/null
  rm -rf "$work"
}
trap clean_up EXIT
fail() {
  echo "failed: $*"
  cat "$work/log" 2>/dev/null
  exit 1
}

# Xvfb picks a free display itself and writes its number.
exec 3>"$work/display"
Xvfb -displayfd 3 -screen 0 1680x900x24 -nolisten tcp >/dev/null 2>&1 &
xvfb=$!
exec 3>&-
for _ in $(seq 100); do
  [ -s "$work/display" ] && break
  sleep 0.1
done
[ -s "$work/display" ] || fail "Xvfb did not start"
export DISPLAY=:$(cat "$work/display")
export LIBGL_ALWAYS_SOFTWARE=1
export XDG_PICTURES_DIR=$work
export XDG_CONFIG_HOME=$work

"$program" "$scene" >"$work/log" 2>&1 &
app=$!
alive() { kill -0 "$app" 2>/dev/null || fail "the program ended by itself: $1"; }

window=
for _ in $(seq 200); do
  window=$(xdotool search --onlyvisible --class asos 2>/dev/null | head -1)
  [ -n "$window" ] && break
  alive "before its window came"
  sleep 0.1
done
[ -n "$window" ] || fail "no window"

# The colour spread of the picture's area, as "deviation count-of-colours".
picture_spread() {
  import -window root "$1"
  eval "$(xdotool getwindowgeometry --shell "$window")"
  convert "$1" -crop "$((WIDTH - 340))x$((HEIGHT - 40))+$X+$Y" +repage \
    -format "%[fx:standard_deviation*1000] %k" info:
}
# Waits until the area shows a picture: many colours, not one surface.
wait_for_picture() {
  for _ in $(seq 100); do
    read -r deviation colours < <(picture_spread "$1")
    if [ "${deviation%.*}" -gt 30 ] && [ "$colours" -gt 50 ]; then return; fi
    alive "$1"
    sleep 0.2
  done
  fail "$1 shows no picture (deviation $deviation, $colours colours)"
}

wait_for_picture window_start.png
eval "$(xdotool getwindowgeometry --shell "$window")"
right=$((X + WIDTH))
echo "window $WIDTH x $HEIGHT"

# The row of EPS in the panel, as bytes.
eps_y=170
eps_row() { convert "$1" -crop "220x20+$((right - 240))+$((Y + eps_y - 10))" +repage rgb:- | cksum; }

# Drag EPS from one end of its slider towards the other.
xdotool mousemove $((right - 60)) $((Y + eps_y)) mousedown 1
for x in 90 120 150 180; do
  xdotool mousemove $((right - x)) $((Y + eps_y))
  sleep 0.05
done
xdotool mouseup 1
sleep 0.3
alive "EPS"
wait_for_picture window_eps.png
for _ in $(seq 50); do
  [ "$(eps_row window_start.png)" != "$(eps_row window_eps.png)" ] && break
  sleep 0.2
  wait_for_picture window_eps.png
done
[ "$(eps_row window_start.png)" != "$(eps_row window_eps.png)" ] || fail "EPS did not follow the drag"

# Undo brings the old value back, redo the new one.
undone() {
  for _ in $(seq 50); do
    import -window root "$1"
    [ "$(eps_row window_start.png)" = "$(eps_row "$1")" ] && return 0
    sleep 0.2
  done
  return 1
}
xdotool mousemove $((X + 400)) $((Y + 300))
sleep 0.6
xdotool key ctrl+z
undone window_undo.png || fail "Ctrl+Z did not bring EPS back"
xdotool key ctrl+shift+z
sleep 0.5
alive "redo"

# A click shows how a pixel was split; Escape closes that.
xdotool mousemove $((X + 600)) $((Y + 400)) click 1
sleep 1
import -window root window_pixel.png
alive "a picked pixel"
xdotool key Escape
sleep 0.3
alive "Escape closed more than the pixel"

# Orbit with the left button, come closer with the wheel.
xdotool mousemove $((X + 400)) $((Y + 300)) mousedown 1
for x in 430 460 500; do
  xdotool mousemove $((X + x)) $((Y + 320))
  sleep 0.05
done
xdotool mouseup 1 click 4 click 4
sleep 0.3
alive "orbit"
wait_for_picture window_orbit.png
if [ "$(convert window_eps.png rgb:- | cksum)" = "$(convert window_orbit.png rgb:- | cksum)" ]; then
  fail "the orbit changed nothing on the screen"
fi

# Save the picture, resize, minimise and come back.
xdotool key p
for _ in $(seq 50); do
  compgen -G "$work/*-001.png" >/dev/null && break
  sleep 0.1
done
compgen -G "$work/*-001.png" >/dev/null || fail "P saved no picture"
xdotool windowsize "$window" 700 500
sleep 0.6
alive "resize"
xdotool windowunmap "$window"
sleep 0.3
alive "minimised"
xdotool windowmap "$window"
sleep 0.5
wait_for_picture window_resized.png

# Types a path into the open dialog.
xdotool windowfocus "$window" 2>/dev/null
open_file() {
  xdotool key ctrl+o
  sleep 0.5
  xdotool key ctrl+a
  xdotool type --delay 20 "$1"
  sleep 0.5
  xdotool key Return
}
title=$(xdotool getwindowname "$window")
open_file /no/such.glb
sleep 1
alive "a file that does not exist"
[ "$(xdotool getwindowname "$window")" = "$title" ] || fail "an error changed the scene"
wait_for_picture window_error.png

bike=${ASOS_SHARED:-$(dirname "$0")/../../../shared}/scenes/Bike/Bike.glb
if [ -f "$bike" ]; then
  open_file "$(realpath "$bike")"
  for _ in $(seq 300); do
    [ "$(xdotool getwindowname "$window")" = "Bike - ASOS" ] && break
    alive "Bike"
    sleep 0.1
  done
  [ "$(xdotool getwindowname "$window")" = "Bike - ASOS" ] || fail "Bike was not opened"
  wait_for_picture window_bike.png
fi

xdotool key ctrl+q
for _ in $(seq 100); do
  kill -0 "$app" 2>/dev/null || break
  sleep 0.1
done
kill -0 "$app" 2>/dev/null && fail "Ctrl+Q did not end the program"
wait "$app"
code=$?
app=
[ "$code" -eq 0 ] || fail "exit code $code"
[ -s "$work/log" ] && fail "the program complained"
echo "passed"
