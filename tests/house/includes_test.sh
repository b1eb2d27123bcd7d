#!/usr/bin/env bash
# Includes go one way: app -> ui -> renderer. Inside renderer/ each folder may include itself and
# the folders that renderer/CMakeLists.txt adds before it. The renderer uses no OpenGL, GLFW or
# ImGui and prints nothing. Usage: includes_test.sh SOURCE_DIR
set -euo pipefail
cd -- "$1"
status=0

# forbid FOLDER PATTERN REASON: no line of code in FOLDER may match PATTERN, except in comments.
forbid() {
  local folder=$1 pattern=$2 reason=$3 hit text
  [[ -d $folder ]] || return 0
  while IFS= read -r hit; do
    text=${hit#*:*:}
    grep -qE -- "$pattern" <<<"${text%%//*}" || continue
    status=1
    printf '%s\n    %s\n' "$hit" "$reason"
  done < <(grep -rnE --include='*.h' --include='*.cpp' -- "$pattern" "$folder" || true)
}

count=$(find app include renderer ui tests \( -name '*.h' -o -name '*.cpp' \) 2>/dev/null | wc -l)
if ((count < 20)); then
  printf 'only %d sources found under %s: this test looks in the wrong place\n' "$count" "$PWD"
  exit 1
fi

include='^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"]'
forbid renderer "$include(app|ui|tests)/" 'renderer/ must not know app/, ui/ or tests/'
forbid ui "$include(app|tests)/" 'ui/ must not know app/ or tests/'
forbid app "${include}tests/" 'app/ must not know tests/'
forbid renderer "$include(GL/|GLES|GLFW/|EGL/|osmesa|imgui|CLI/)" \
  'renderer/ includes no OpenGL, GLFW, ImGui or command line'
forbid renderer '(^|[^[:alnum:]_])(printf|fprintf|vprintf|vfprintf|puts|fputs|putchar|perror)[[:space:]]*\(' \
  'renderer/ prints nothing'
forbid renderer 'std::(cout|cerr|clog|print)|fmt::print|#[[:space:]]*include[[:space:]]*<iostream>' \
  'renderer/ prints nothing'

# Inside renderer/, the order of its add_subdirectory lines counts.
folders=$(sed -nE 's/^add_subdirectory\(([a-z_]+)\)$/\1/p' renderer/CMakeLists.txt)
while IFS= read -r folder; do
  grep -qx "$folder" <<<"$folders" && continue
  status=1
  echo "renderer/$folder is not added by renderer/CMakeLists.txt"
done < <(find renderer -mindepth 1 -maxdepth 1 -type d -printf '%f\n')
lower=
for folder in $folders; do
  lower+=${lower:+|}$folder
  above=$(grep -vxE "$lower" <<<"$folders" | paste -sd '|' || true)
  [[ -n $above ]] || break
  forbid "renderer/$folder" "${include}renderer/($above)/" \
    "renderer/CMakeLists.txt adds renderer/$folder before it"
done
if ((${#lower} < 100)); then
  echo "renderer/CMakeLists.txt adds only $lower: this test looks in the wrong place"
  exit 1
fi

((status == 0)) && printf '%d sources, all includes run app -> ui -> renderer, and one way in it\n' "$count"
exit $status
