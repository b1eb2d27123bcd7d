#!/usr/bin/env bash
# stb's writer is compiled into one source file with internal linkage, and its reader is not used:
# libdraco exports an old copy that the program would call instead. Usage: symbols_test.sh ASOS
set -euo pipefail
asos=$1
count=$(nm -C "$asos" | grep -cE ' [a-zA-Z] stbi_' || true)
((count > 0)) || {
  echo "$asos has no symbol of stb_image at all: this test looks in the wrong place"
  exit 1
}
# Local symbols have lower-case letters; exported and undefined ones have capitals, or w.
if nm -C "$asos" | grep -E ' [A-Zw] (stbi_|stbi__)'; then
  echo 'these symbols of stb_image are not private to one file: another library may take their place'
  exit 1
fi
echo "$count symbols of stb_image, all private"
