#!/usr/bin/env bash
# Installs the library into a temporary prefix, builds the examples against it by find_package and pkg-config,
# and runs those that need no display. Usage: library_test.sh BUILD_DIR SOURCE_DIR
set -euo pipefail
build=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
fail() {
  echo "$*"
  exit 1
}

for component in development library; do
  cmake --install "$build" --prefix "$work/prefix" --component $component >"$work/log" 2>&1 ||
    fail "$(cat "$work/log")"
done
[[ ! -e $work/prefix/bin ]] || fail 'the development files contain the program'
cmake -S "$source/examples" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror' >"$work/log" 2>&1 ||
  fail "$(cat "$work/log")"
cmake --build "$work/build" >"$work/log" 2>&1 || fail "$(cat "$work/log")"
for example in "$source"/examples/*.cpp; do
  (($(wc -l <"$example") < 80)) || fail "$example is too long for an example"
  [[ -x $work/build/$(basename -- "$example" .cpp) ]] || fail "$example is not built"
done

"$work/build/render_file" builtin:boxes "$work/boxes.png" 48 32 2>/dev/null >"$work/said" ||
  fail 'render_file fails'
[[ $(identify -format '%wx%h' "$work/boxes.png") == 48x32 ]] || fail 'render_file wrote no picture'
if "$work/build/render_file" "$work/none.glb" "$work/none.png" 2>"$work/said"; then
  fail 'render_file opens a file that is not there'
fi
grep -q 'none.glb' "$work/said" || fail "its error does not name the file: $(cat "$work/said")"
"$work/build/own_arrays" >"$work/said" || fail 'own_arrays fails'
grep -q 'cause outline' "$work/said" && grep -qE 'cut +[1-9]' "$work/said" ||
  fail "own_arrays prints no subdivision: $(cat "$work/said")"

# pkg-config finds the same library, wherever the tree is moved.
mv "$work/prefix" "$work/moved"
pc=$(find "$work/moved" -name asos.pc -printf '%h\n')
flags=$(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs asos)
echo '#include <asos/asos.h>
int main() { return asos::api::method_names().size() > 5 && asos::api::Scene::load("no such.glb") ? 1 : 0; }' \
  >"$work/small.cpp"
# shellcheck disable=SC2086
"${CXX:-c++}" -std=c++20 "$work/small.cpp" -o "$work/small" $flags 2>"$work/log" || fail "$(cat "$work/log")"
LD_LIBRARY_PATH=$(dirname -- "$pc") "$work/small" || fail 'a program linked by pkg-config fails'
[[ $(PKG_CONFIG_PATH=$pc pkg-config --modversion asos) == "$(sed -nE 's/^project\(asos VERSION ([0-9.]+).*/\1/p' \
  "$source/CMakeLists.txt")" ]] || fail 'pkg-config tells another version'
echo 'installed, found by CMake and pkg-config, examples run'
