#!/usr/bin/env bash
# Drops invalid files on the real window like a file manager, while a scene is open. The scene
# stays; the message is that of the command line, is displayed, and can be copied, escaped. Then
# drops a valid file. Also uses the files of hostile/ in the shared folder, if there are any.
#
# Usage: drop_test.sh ASOS_PROGRAM DROP_FILE_PROGRAM CLIPBOARD_TEXT_PROGRAM SHARED
set -u
program=$1
drop=$2
clipboard=$3
shared=${ASOS_SHARED:-$4}
source "$(dirname "$0")/virtual_screen.sh"

mkdir "$work/files"
printf '{"asset":{"version":"2.0"}' >"$work/files/torn.gltf"
printf 'glTF' >"$work/files/"$'a\033[31m\nasos: all fine\001%41\xe2\x80\xae.glb'
printf '{"asset":{"version":"2.0"},"extensionsUsed":["E\\u001b[2J\\nF"],"extensionsRequired":["E\\u001b[2J\\nF"]}' \
  >"$work/files/required.gltf"
printf '\211PNG\r\n\032\n' >"$work/files/torn.png"
printf 'v/1\001' >"$work/files/torn.exr"
mkdir "$work/files/folder.glb"
"$program" export-scene boxes -o "$work/good.glb" >/dev/null || fail 'no scene to drop'

start builtin:office --size 640x400 --max 0 --reflections 0
wait_until 'no window' found_window
titled() { [ "$(xdotool getwindowname "$window")" = "$1" ]; }
wait_until 'no title' titled 'office - ASOS'
geometry
picture="$((WIDTH - 340))x$((HEIGHT - 40))+$X+$Y"
xdotool mousemove $((X + 100)) $((Y + 300))
wait_until 'the render does not end' at_rest drop_before.png "$picture"

# The notice's area: the part of the picture that differs from the previous one.
notice_place() {
  convert "$1" drop_before.png -crop "$picture" +repage -compose difference -composite \
    -threshold 0 -format '%@' info:
}
copied() {
  local width height left top
  shot drop_notice.png
  IFS='x+' read -r width height left top < <(notice_place drop_notice.png)
  xdotool mousemove $((X + left + 20)) $((Y + top + height - 16)) click 1
  sleep 0.2
  "$clipboard" >"$work/copied" 2>/dev/null && ! cmp -s "$work/copied" "$work/copied_before"
}

refused=0
# Checks that must hold for every invalid file.
judge() {
  local file=$1 name
  name=$(printf '%q' "${file##*/}")
  "$drop" "$window" "$file" || fail "$name: the window does not take it"
  wait_until "$name: no message" changed drop_notice.png drop_before.png "$picture" 3000
  titled 'office - ASOS' || fail "$name: the scene did not stay"
  wait_until "$name: nothing was copied" copied
  mv "$work/copied" "$work/copied_before"
  if LC_ALL=C grep -qP '[\x00-\x1f\x7f]|\xe2\x80[\xaa-\xae]' "$work/copied_before"; then
    fail "$name: what was copied is not escaped: $(cat -v "$work/copied_before")"
  fi
  [ -s "$work/copied_before" ] || fail "$name: nothing was said"
  # For folders and missing files the program prints more.
  if [ -f "$file" ] && [[ $file == *.gl* ]]; then
    "$program" info "$file" >/dev/null 2>"$work/said"
    sed -i 's/^asos: //' "$work/said"
    [ "$(cat "$work/said")" = "$(cat "$work/copied_before")" ] ||
      fail "$name: the window says $(cat "$work/copied_before"), the program $(cat "$work/said")"
  fi
  xdotool mousemove $((X + 100)) $((Y + 300)) key Escape
  wait_until "$name: the scene is not as it was" same drop_after.png drop_before.png "$picture"
  refused=$((refused + 1))
}

: >"$work/copied_before"
while IFS= read -r -d '' file; do judge "$file"; done < <(find "$work/files" -mindepth 1 -print0 | sort -z)
judge "$work/absent.gltf"
if [ -d "$shared/hostile" ]; then
  while IFS= read -r -d '' file; do
    case $file in
      *.tsv) ;;
      *.gltf) "$program" info "$file" >/dev/null 2>&1 || judge "$file" ;;
      *) judge "$file" ;;
    esac
  done < <(find "$shared/hostile" -type f -print0 | sort -z)
fi
"$drop" "$window" "$work/good.glb" || fail 'the window does not take what is sound'
wait_until 'what is sound is not opened' titled 'good.glb - ASOS'
[ -s "$work/log" ] && fail 'the program complained'
echo "passed: $refused files"
