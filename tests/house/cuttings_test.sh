#!/usr/bin/env bash
# No small file is a part of the one file that includes it (cuttings.py), except those that cuttings.txt lists
# with a reason. Usage: cuttings_test.sh SOURCE_DIR. Exit code 77: skipped, there is no python3.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$1" && pwd)
command -v python3 >/dev/null || {
  echo 'skipped: python3 is not installed'
  exit 77
}
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
export PYTHONDONTWRITEBYTECODE=1

# The script itself, by a tree with one cutting among files that are none.
mkdir -p "$work/renderer/a" "$work/renderer/b" "$work/app" "$work/ui" "$work/tests"
source_of() {
  local name
  for name in "$@"; do printf '#include "renderer/%s.h"\n' "$name"; done
  printf 'int number;\n'
}
cd -- "$work/renderer"
source_of >a/cutting.h # only a/user includes it
source_of >a/tested.h  # has a test of its own
source_of >a/shared.h  # two files include it
source_of >a/other.h   # a file of another folder includes it
source_of >a/listed.h  # an exception
source_of >a/of_long.h # a/long has no room for it
for ((i = 0; i < 80; ++i)); do echo "int large_$i;"; done >a/large.h
source_of a/cutting a/tested a/shared a/listed a/large >a/user.cpp
source_of a/shared a/other >b/user.cpp
{
  source_of a/of_long
  for ((i = 0; i < 400; ++i)); do echo '// A comment.'; done
} >a/long.cpp
touch "$work/tests/tested_test.cpp"
cd -- "$work"
echo 'renderer/a/listed.h for a reason' >listed.txt
expected='renderer/a/cutting.h is small and only renderer/a/user includes it: join them, test it, or give a reason'
found=$(python3 "$here/cuttings.py" "$work" listed.txt) && {
  echo 'cuttings.py accepts a cutting'
  exit 1
}
[[ $found == "$expected" ]] || {
  printf 'cuttings.py miscounts; expected and found:\n%s\n%s\n' "$expected" "$found"
  exit 1
}
printf '%s\n' 'renderer/a/listed.h' 'renderer/a/cutting.h reason' 'renderer/a/gone.h reason' >listed.txt
expected='listed.txt: renderer/a/listed.h has no reason
listed.txt: renderer/a/gone.h is no exception any more'
found=$(python3 "$here/cuttings.py" "$work" listed.txt) || true
[[ $found == "$expected" ]] || {
  printf 'cuttings.py misreads its list; expected and found:\n%s\n%s\n' "$expected" "$found"
  exit 1
}

python3 "$here/cuttings.py" "$root" "$here/cuttings.txt" || exit 1
echo "no cuttings, $(grep -vc '^#' "$here/cuttings.txt") exceptions"
