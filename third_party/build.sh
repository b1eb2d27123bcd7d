# Sourced by ./run and ./check, which set `root`. Builds a preset, with output only if something
# fails.

# Runs a command with its output in a log; shows the log if it fails.
quietly() {
  local log=$1
  shift
  if ! "$@" >"$log" 2>&1; then
    cat -- "$log" >&2
    printf '%s: failed (its output is above): %s\n' "${0##*/}" "$*" >&2
    return 1
  fi
}

# build_preset PRESET [TARGET...]: configures and builds; without targets, everything.
build_preset() {
  local preset=$1
  shift
  local directory="$root/build/$preset"
  mkdir -p -- "$directory"
  # A tree that was moved or copied cannot use its old build folder.
  local cache="$directory/CMakeCache.txt"
  if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    rm -rf -- "$directory"
    mkdir -p -- "$directory"
  fi
  if [[ ! -f $directory/build.ninja || $root/CMakePresets.json -nt $directory/build.ninja ]]; then
    [[ -f $directory/build.ninja ]] || printf 'Building (the first time takes minutes) ...\n' >&2
    (cd -- "$root" && quietly "$directory/configure.log" cmake --preset "$preset") || return 1
  fi
  (cd -- "$root" && quietly "$directory/build.log" cmake --build --preset "$preset" \
    --parallel "$(nproc)" ${1:+--target "$@"})
}
