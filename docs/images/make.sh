#!/usr/bin/env bash
# Renders the pictures of README.md and docs/ into this folder.
# Usage: make.sh ASOS [WINDOW_PAGES]; WINDOW_PAGES, tests/window_pages of the build, draws the
# window.
set -euo pipefail
asos=$(readlink -f -- "$1")
pages=${2:+$(readlink -f -- "$2")}
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")"

render() { "$asos" render "$@" --quiet; }
render builtin:office -o office.png --size 960x540
render builtin:glass -o glass.png --size 480x270
for light in "" -ball -linear -rectangle; do
  render "builtin:primitives$light" -o "primitives$light.png" --size 480x320
done
render builtin:house-textured -o textures.png --size 640x432 --max 2 --eps 0 --tr 2
render builtin:house-mirror -o mirror.png --size 640x432 --max 3 --eps 0.125
render builtin:house-mirror -o mirror-n64.png --size 640x432 --max 3 --eps 0.125 --dfr 0.05,1,64
for method in asos cone covers mask; do
  render builtin:cards -o "cards-$method.png" --size 320x180 --method "$method"
done
fence=$(mktemp --suffix=.png)
trap 'rm -f -- "$fence"' EXIT
render builtin:fence -o "$fence" --size 320x180 --split-map fence-levels.png
render builtin:fence -o "$fence" --size 320x180 --split-map fence-causes.png --split-map-by cause
if [[ -n $pages ]]; then "$pages" --manual .; fi
