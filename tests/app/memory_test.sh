#!/usr/bin/env bash
# Memory for files with many small entries is limited to three times the file's size plus 300 MB, as
# for the corpus. Usage: memory_test.sh ASOS MEASURED
set -uo pipefail
asos=$1
measured=$2
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
failed=0

# check FILE ARGUMENT...: runs the program, which must succeed.
check() {
  local file=$1 kb cpu_ms used_kb
  shift
  kb=$(($(stat -c %s -- "$file") / 1000))
  "$measured" "$asos" "$@" 9>"$work/measures" >"$work/out" 2>&1 </dev/null || {
    failed=1
    echo "failed: $* ($(head -c 300 "$work/out"))"
  }
  read -r cpu_ms used_kb <"$work/measures"
  echo "$(basename -- "$file"), $kb kB: $1 took $used_kb kB and $cpu_ms ms"
  ((used_kb <= 3 * kb + 300000)) || {
    failed=1
    echo "too much"
  }
}

mesh='"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]'
buffer='"buffers":[{"byteLength":36,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]'
accessor='"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3}]'

# Lights that every point of a batch evaluates.
{
  printf '{"asset":{"version":"2.0"},"scene":0,%s,%s,%s' "$mesh" "$buffer" "$accessor"
  printf ',"bufferViews":[{"buffer":0,"byteLength":36}],"extensionsUsed":["KHR_lights_punctual"]'
  printf ',"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}}'
  awk 'BEGIN {
    printf ",\"scenes\":[{\"nodes\":[0"
    for (i = 1; i <= 20000; ++i) printf ",%d", i
    printf "]}],\"nodes\":[{\"mesh\":0}"
    for (i = 1; i <= 20000; ++i)
      printf ",{\"translation\":[%d,%d,3],\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}}",
        i % 100, i / 100
    printf "]}"
  }'
} >"$work/lights.gltf"
check "$work/lights.gltf" render "$work/lights.gltf" --size 16x12 --max 1 --quiet --threads 2 \
  -o "$work/picture.png"

# Buffer views that nothing uses.
{
  printf '{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],%s,%s,%s' \
    "$mesh" "$buffer" "$accessor"
  awk 'BEGIN {
    printf ",\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}"
    for (i = 1; i <= 300000; ++i) printf ",{\"buffer\":0,\"byteLength\":4}"
    printf "]}"
  }'
} >"$work/views.gltf"
check "$work/views.gltf" info "$work/views.gltf"
exit $failed
