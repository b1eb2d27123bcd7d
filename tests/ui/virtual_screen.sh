# Sourced by tests of the real window after they set `program`. Starts a virtual screen with the
# program on it, and has functions to look at it. The tests are skipped if a tool is missing.
skip=77

for tool in Xvfb xdotool import convert compare; do
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
# Waits until a command succeeds, for at most a minute, which is ample on any machine.
wait_until() {
  local what=$1
  shift
  for _ in $(seq 600); do
    "$@" && return
    if [ -n "$app" ]; then kill -0 "$app" 2>/dev/null || fail "the program ended: $what"; fi
    sleep 0.1
  done
  fail "$what"
}

# Xvfb chooses a free display and writes its number, maybe before it accepts clients. On a busy
# machine another server may have taken the number meanwhile. An Xvfb would restart when its last
# client leaves, and reject clients during that time.
displays=0
answers() {
  local number
  number=$(cat "$work/display")
  if [ -n "$number" ] && DISPLAY=:$number xdotool getdisplaygeometry >/dev/null 2>&1; then
    export DISPLAY=:$number
    return 0
  fi
  kill -0 "$xvfb" 2>/dev/null && [ "$((++asked % 50))" -ne 0 ] && return 1
  [ "$((++displays))" -gt 5 ] && fail 'Xvfb did not start'
  [ -n "$xvfb" ] && kill "$xvfb" 2>/dev/null
  : >"$work/display"
  exec 3>"$work/display"
  Xvfb -displayfd 3 -screen 0 1680x900x24 -nolisten tcp -noreset >/dev/null 2>&1 &
  xvfb=$!
  exec 3>&-
  return 1
}
asked=0
: >"$work/display"
wait_until 'no display answers' answers
export LIBGL_ALWAYS_SOFTWARE=1
export XDG_PICTURES_DIR=$work
export XDG_CONFIG_HOME=$work
# Settings with the tour already seen, so that it does not start.
mkdir -p "$work/asos" && echo '{"tour_seen": true}' >"$work/asos/window.json"

window=
start() {
  "$program" "$@" --no-shadows >"$work/log" 2>&1 &
  app=$!
}
found_window() {
  window=$(xdotool search --onlyvisible --class asos 2>/dev/null | head -1)
  [ -n "$window" ]
}

# Low compression: there are many pictures, and most are only compared.
shot() { import -window root -define png:compression-level=1 -define png:compression-filter=0 "$1"; }
geometry() { eval "$(xdotool getwindowgeometry --shell "$window")"; }
# Number of pixels of an area (WxH+X+Y) that differ between two pictures of the screen.
differing() {
  compare -extract "$3" -metric AE "$1" "$2" null: 2>&1
}
# NEW BEFORE AREA: the area has changed since BEFORE by at least a few hundred pixels, or is
# unchanged.
changed() {
  shot "$1"
  [ "$(printf '%.0f' "$(differing "$1" "$2" "$3")")" -gt "${4:-300}" ]
}
same() {
  shot "$1"
  [ "$(printf '%.0f' "$(differing "$1" "$2" "$3")")" -eq 0 ]
}
# Waits until two consecutive pictures of the screen are equal.
at_rest() {
  shot "$work/rest.png"
  sleep 0.4
  same "$1" "$work/rest.png" "$2"
}
