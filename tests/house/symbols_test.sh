#!/usr/bin/env bash
# stb's writer is compiled into one source file and private to it, and nothing of its reader is asked for:
# libdraco exports an old copy, whose functions the program would call. Usage: symbols_test.sh ASOS
set -euo pipefail
asos=$1
count=$(nm -C "$asos" | grep -cE ' [a-zA-Z] stbi_' || true)
((count > 0)) || {
  echo "$asos has no symbol of stb_image at all: this test looks in the wrong place"
  exit 1
}
# Local symbols have small letters; what others can see or define has capitals, and w.
if nm -C "$asos" | grep -E ' [A-Zw] (stbi_|stbi__)'; then
  echo 'these symbols of stb_image are not private to one file: another library may take their place'
  exit 1
fi
echo "$count symbols of stb_image, all private"
