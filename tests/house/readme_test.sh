#!/usr/bin/env bash
# Runs the README's commands: every ```sh block that follows a line `<!-- checked -->` has to
# succeed, in an empty folder, with the freshly built asos on the PATH. What the README names with a
# trailing slash or links to has to exist.
# Usage: readme_test.sh SOURCE_DIR ASOS
set -euo pipefail
readme="$1/README.md"
program=$2

work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
mkdir "$work/bin" "$work/here"
ln -s -- "$program" "$work/bin/asos"

# One file a block: $work/block-1, ...
awk -v prefix="$work/block-" '
  /^<!-- checked -->$/ { wanted = 1; next }
  /^```sh$/ && wanted { inside = 1; wanted = 0; ++n; next }
  /^```$/ { inside = 0; next }
  inside { print > (prefix n) }
  !inside && NF { wanted = 0 }
' "$readme"

count=0
for block in "$work"/block-*; do
  [[ -f $block ]] || break
  count=$((count + 1))
  echo "-- block $count:"
  cat -- "$block"
  (cd -- "$work/here" && env -u DISPLAY -u WAYLAND_DISPLAY PATH="$work/bin:$PATH" bash -eu "$block")
done
if ((count == 0)); then
  echo "no checked block was found in $readme"
  exit 1
fi

while IFS= read -r name; do
  [[ $name == http* || -e $1/$name ]] || {
    echo "README.md names $name, which does not exist"
    exit 1
  }
done < <(grep -oE '\]\([^)]+\)|`[a-z_/]+/`' "$readme" | sed -E 's/^\]\(|\)$|`//g' |
  grep -vxE 'bench/|fuzz/|house/')
echo "$count blocks ran"
