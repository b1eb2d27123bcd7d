#!/usr/bin/env bash
# Uses the real window on a virtual screen like a person: waits for the picture, drags EPS, undoes
# that, clicks a pixel, orbits, resizes, minimises, saves the picture in several ways, and drops the
# saved picture on the window. Opens a missing file and an existing one (if the shared scenes are
# there), edits a mirror's blur by its curve in another scene, and quits. Each step waits for its
# effect. Pictures of the screen stay in the current directory.
#
# Usage: window_test.sh ASOS_PROGRAM DROP_FILE_PROGRAM [SCENE]
set -u
program=$1
drop=$2
scene=${3:-builtin:boxes}
source "$(dirname "$0")/virtual_screen.sh"

start "$scene" --size 640x400 --max 1 --reflections 0
wait_until 'no window' found_window
wait_until 'no title' eval '[[ $(xdotool getwindowname "$window") == *" - ASOS" ]]'

# The picture's area shows many colours, not a single one.
shows_picture() {
  shot "$1"
  geometry
  local deviation colours
  read -r deviation colours < <(
    convert "$1" -crop "$((WIDTH - 340))x$((HEIGHT - 40))+$X+$Y" +repage \
      -format '%[fx:round(standard_deviation*1000)] %k' info:)
  [ "$deviation" -gt 30 ] && [ "$colours" -gt 50 ]
}
wait_for_picture() { wait_until "$1 shows no picture" shows_picture "$1"; }
wait_for_picture window_start.png
geometry
picture="$((WIDTH - 340))x$((HEIGHT - 40))+$X+$Y"
whole="${WIDTH}x$HEIGHT+$X+$Y"
wait_until 'the render does not end' at_rest window_start.png "$whole"
echo "window $WIDTH x $HEIGHT"

# Drags EPS along its slider in the bar under the picture; its number follows. A mark of the value
# before stands beside the number.
eps_y=$((HEIGHT - 49))
eps="80x20+$((X + 130))+$((Y + eps_y - 10))"
xdotool mousemove $((X + 220)) $((Y + eps_y)) mousedown 1
for x in 230 250 270 290; do
  xdotool mousemove $((X + x)) $((Y + eps_y))
  sleep 0.05
done
xdotool mouseup 1 mousemove $((X + 400)) $((Y + 300))
wait_until 'EPS did not follow the drag' changed window_eps.png window_start.png "$eps" 20
wait_until 'EPS does not rest' at_rest window_eps.png "$whole"

# Undo restores the old value, redo the new one.
xdotool key ctrl+z
wait_until 'Ctrl+Z did not bring EPS back' same window_undo.png window_start.png "$eps"
# No other step can be redone, so the key may be pressed until it has an effect.
redone() {
  xdotool key ctrl+shift+z
  same window_redo.png window_eps.png "$eps"
}
wait_until 'Ctrl+Shift+Z did not bring EPS again' redone
wait_until 'redo does not rest' at_rest window_redo.png "$whole"

# Ctrl + click selects an object and shows how the pixel was split; Escape closes its panel, and once
# more ends the selection.
xdotool mousemove $((X + 300)) $((Y + 200)) keydown ctrl click 1 keyup ctrl
wait_until 'no pixel was shown' changed window_pixel.png window_redo.png "$picture" 5000
xdotool key Escape mousemove $((X + 400)) $((Y + 300))
wait_until 'the pixel was not closed' changed window_closed.png window_pixel.png "$picture" 5000
xdotool key Escape
wait_until 'the object stays selected' same window_closed.png window_redo.png "$picture"

# Orbit with the left button, and zoom in with the wheel.
xdotool mousedown 1
for x in 430 460 500; do
  xdotool mousemove $((X + x)) $((Y + 320))
  sleep 0.05
done
xdotool mouseup 1 click 4 click 4
wait_until 'the orbit changed nothing' changed window_orbit.png window_redo.png "$picture" 20000
wait_for_picture window_orbit.png
wait_until 'the orbit does not rest' at_rest window_orbit.png "$picture"

# Saves the picture by key; then as EXR and at a larger size with the dialog, whose buttons are
# located in the picture of the screen.
xdotool key p
wait_until 'P saved no picture' compgen -G "$work/*-001.png" >/dev/null
saved=$(compgen -G "$work/*-001.png")
"$program" render --from "$saved" -o "$work/again.png" --quiet || fail 'the picture tells nothing'
[ "$(compare -metric AE "$saved" "$work/again.png" null: 2>&1)" = 0 ] ||
  fail 'what was saved is not what is rendered from it'

# Dropping the picture restores the view after it was changed.
wait_until 'saving does not rest' at_rest window_saved.png "$picture"
xdotool click 5 click 5 click 5 click 5
wait_until 'the wheel changed nothing' changed window_far.png window_saved.png "$picture" 20000
"$drop" "$window" "$saved" || fail 'the window does not take what is dropped'
wait_until 'the dropped picture did not bring the view back' \
  same window_dropped.png window_saved.png "$picture"
convert -size 8x8 xc:red "$work/plain.png"
"$drop" "$window" "$work/plain.png" || fail 'the window does not take what is dropped'
wait_until 'no message' changed window_plain.png window_dropped.png "$picture" 3000
xdotool key Escape
wait_until 'the message stays' same window_plain_closed.png window_dropped.png "$picture"

# Chooses EXR in the dialog with a click; Tab and the arrow keys could do it, too.
xdotool key ctrl+s
wait_until 'no dialog' changed window_save.png window_dropped.png "$picture" 20000
wait_until 'the dialog does not rest' at_rest window_save.png "$picture"
xdotool key Escape
wait_until 'the dialog stays' same window_save_closed.png window_dropped.png "$picture"

# Flies: while W is held the camera moves, even if every frame takes longer than its interval. When
# W is released the camera stops, and the window reacts to the next input.
wait_until 'the window does not rest' at_rest window_before_flight.png "$picture"
xdotool mousemove $((X + 300)) $((Y + 200)) mousedown 3 keydown w
sleep 0.5
xdotool keyup w mouseup 3 mousemove $((X + 400)) $((Y + 300))
wait_until 'it did not fly' changed window_flight.png window_before_flight.png "$picture" 20000
wait_until 'it flies on' at_rest window_flight.png "$picture"
xdotool key ctrl+z
wait_until 'no key counts after a flight' same window_flown_back.png window_before_flight.png "$picture"
# Escape closes open panels one by one, but never the window.
xdotool key Escape key Escape key Escape

# Resizes, minimises and restores the window.
resized() {
  geometry
  [ "$WIDTH" -eq 700 ] && [ "$HEIGHT" -eq 500 ]
}
xdotool windowsize "$window" 700 500
wait_until 'the window was not resized' resized
wait_for_picture window_small.png
xdotool windowunmap "$window"
wait_until 'the window was not minimised' eval '! xdotool search --onlyvisible --class asos >/dev/null'
xdotool windowmap "$window"
wait_until 'the window did not come back' found_window
wait_for_picture window_resized.png

# Types a path into the open dialog.
xdotool windowfocus "$window" 2>/dev/null
geometry
picture="$((WIDTH - 340))x$((HEIGHT - 40))+$X+$Y"
open_file() {
  wait_until 'the window does not rest' at_rest "$work/before.png" "$picture"
  xdotool key ctrl+o
  wait_until 'no dialog' changed window_open.png "$work/before.png" "$picture" 5000
  wait_until 'the dialog does not rest' at_rest window_open.png "$picture"
  xdotool key ctrl+a
  xdotool type --delay 20 "$1"
  wait_until 'nothing was typed' changed window_typed.png window_open.png "$picture" 20
  xdotool key Return
}
title=$(xdotool getwindowname "$window")
open_file /no/such.glb
wait_until 'no error was shown' changed window_error.png "$work/before.png" "$picture" 3000
wait_until 'the error does not rest' at_rest window_error.png "$picture"
[ "$(xdotool getwindowname "$window")" = "$title" ] || fail "an error changed the scene"
xdotool key Escape

bike=${ASOS_SHARED:-$(dirname "$0")/../../../shared}/scenes/Bike/Bike.glb
if [ -f "$bike" ]; then
  open_file "$(realpath "$bike")"
  wait_until 'Bike was not opened' \
    eval '[ "$(xdotool getwindowname "$window")" = "Bike.glb - ASOS" ]'
  wait_for_picture window_bike.png
fi

ended() { ! kill -0 "$app" 2>/dev/null; }
quit() {
  local code
  xdotool key ctrl+q
  for _ in $(seq 600); do
    ended && break
    sleep 0.1
  done
  ended || fail "Ctrl+Q did not end the program"
  wait "$app"
  code=$?
  app=
  [ "$code" -eq 0 ] || fail "exit code $code"
  [ -s "$work/log" ] && fail "the program complained"
}
quit

# A blurred mirror: dragging the curve's left end, DFRMIN, up in the tab Scene makes the house's
# reflection less blurred. Undo restores it.
start builtin:house-mirror --size 640x840 --max 0 --reflections 1 --dfr 0.05,1,8
wait_until 'no window with a mirror' found_window
wait_for_picture window_mirror.png
geometry
picture="$((WIDTH - 340))x$((HEIGHT - 40))+$X+$Y"
xdotool mousemove $((X + 300)) $((Y + 300))  # where no tooltip comes up
# Includes the status bar: for a while a pass measures the cost of the next one.
whole="${WIDTH}x$HEIGHT+$X+$Y"
wait_until 'the mirror does not rest' at_rest window_mirror.png "$whole"
xdotool mousemove $((X + WIDTH - 165)) $((Y + 127)) click 1 mousemove $((X + 300)) $((Y + 300))
wait_until 'the panel does not rest' at_rest window_curve.png "$whole"
xdotool mousemove $((X + WIDTH - 288)) $((Y + 701)) mousedown 1
for y in 688 668 638 598; do
  xdotool mousemove $((X + WIDTH - 288)) $((Y + y))
  sleep 0.05
done
xdotool mouseup 1 mousemove $((X + 300)) $((Y + 300))
wait_until 'the curve changed nothing' changed window_edited.png window_mirror.png "$picture" 2000
wait_until 'the edited mirror does not rest' at_rest window_edited.png "$whole"
xdotool key ctrl+z
wait_until 'the blur did not come back' same window_unedited.png window_mirror.png "$picture"
quit
echo "passed"
