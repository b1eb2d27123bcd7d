#!/usr/bin/env bash
# Kinds of lights: no `default:` in a switch over them, one switch over LightShape, and few files
# outside lights/ and gltf/ that name one. Usage: light_kinds_test.sh SOURCE_DIR
set -euo pipefail
export LC_ALL=C
cd -- "$1"
most_files=4
only_switch=renderer/lights/light_shape.h
kinds='point|spot|directional|distant|ball|sphere|sun|linear|segment|capsule|rectangle|polygon|disk'
types='LightShape|Light::Type|LightType|LightKind'
name="($types)::($kinds)([^A-Za-z_]|\$)"
status=0
fail() {
  status=1
  printf '%s\n' "$@"
}

# uses FILE...: "FILE LINE type" or "shape" for each switch whose cases name a kind, "default" for
# its default, "names" for each other line that names a kind. Aliases of the types are replaced.
uses() {
  awk -v name="$name" -v types="$types" '
    FNR == 1 { depth = 0; top = 0; split("", alias) }
    {
      line = $0
      sub(/\/\/.*/, "", line)
      if (line ~ ("using enum .*(" types ")")) print FILENAME, FNR, "names"
      if (match(line, /using [A-Za-z_]+ = /) && line ~ ("(" types ");")) {
        split(substr(line, RSTART), word, /[ ;]/)
        alias[word[2]] = word[4]
      }
      for (short in alias) gsub("(^|[^:A-Za-z_])" short "::", " " alias[short] "::", line)
      if (line !~ /case / && line ~ name) print FILENAME, FNR, "names"
      if (line ~ /(^|[^A-Za-z_])switch *\(/) {
        opened[++top] = depth; at[top] = FNR; named[top] = 0; defaulted[top] = 0
      }
      if (top && line ~ ("case .*" name)) named[top] = match(line, /LightShape/) ? "shape" : "type"
      if (top && line ~ /(^|[^A-Za-z_])default *:/) defaulted[top] = FNR
      depth += gsub(/\{/, "{", line) - gsub(/\}/, "}", line)
      if (top && depth == opened[top] && line ~ /\}/) {
        if (named[top]) print FILENAME, at[top], named[top]
        if (named[top] && defaulted[top]) print FILENAME, defaulted[top], "default"
        --top
      }
    }' "$@"
}

# Tests the search itself.
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cat >"$work/sample.cpp" <<'SAMPLE'
int f(Light light) {
  using Kind = asos::Light::Type;
  if (light.type == Kind::disk || light.type == Kind::diskette) return 0;
  switch (light.type) {  // the first
    case Light::Type::point: {
      return 1;
    }
    default:
      return 2;
  }
  switch (other) {
    case Shape::Type::disk:
      break;
    default:
      break;
  }
  switch (light.type) {
    case Kind::disk:
      return 3;
  }
  switch (light.shape) {
    case LightShape::capsule:
      return 3;
  }
}
SAMPLE
found=$(uses "$work/sample.cpp" | sed "s:^.* \([0-9]* \):\1:")
expected='3 names
4 type
8 default
17 type
21 shape'
[[ $found == "$expected" ]] ||
  fail 'the search for switches is wrong; expected and found:' "$expected" "$found"

mapfile -t sources < <(find app renderer ui include -name '*.h' -o -name '*.cpp' | sort)
all=$(uses "${sources[@]}")
defaults=$(grep ' default$' <<<"$all" || true)
[[ -z $defaults ]] ||
  fail 'a switch over kinds of lights has a default, which hides a kind that is missing:' "$defaults"
shapes=$(grep ' shape$' <<<"$all" | cut -d' ' -f1 | sort -u || true)
[[ $shapes == "$only_switch" ]] ||
  fail "use with_shape instead of a switch over LightShape; the only one is in $only_switch:" \
    "${shapes:-none}"

mapfile -t naming < <(cut -d' ' -f1 <<<"$all" | sort -u | grep -vE '^renderer/(lights|gltf)/' || true)
((${#naming[@]} <= most_files)) ||
  fail "${#naming[@]} files outside lights/ and gltf/ name a kind of light, of at most $most_files:" \
    "${naming[@]}"

if ((status == 0)); then
  echo "no default and one switch over shapes; ${#naming[@]} other files name a kind of light"
fi
exit $status
