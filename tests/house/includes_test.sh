#!/usr/bin/env bash
# Includes run one way, app -> ui -> renderer; the renderer knows no OpenGL, GLFW or ImGui and
# prints nothing. Usage: includes_test.sh SOURCE_DIR
set -euo pipefail
cd -- "$1"
status=0

# forbid FOLDER PATTERN REASON: no line of code (comments aside) of FOLDER may match PATTERN.
forbid() {
  local folder=$1 pattern=$2 reason=$3 file found
  [[ -d $folder ]] || return 0
  while IFS= read -r -d '' file; do
    found=$(sed -e 's://.*$::' -- "$file" | grep -nE -- "$pattern" || true)
    [[ -n $found ]] || continue
    status=1
    while IFS= read -r line; do printf '%s:%s\n    %s\n' "$file" "$line" "$reason"; done <<<"$found"
  done < <(find "$folder" \( -name '*.h' -o -name '*.cpp' \) -print0)
}

count=$(find app renderer ui tests \( -name '*.h' -o -name '*.cpp' \) 2>/dev/null | wc -l)
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

((status == 0)) && printf '%d sources, all includes run app -> ui -> renderer\n' "$count"
exit $status
