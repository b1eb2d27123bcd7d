#!/usr/bin/env bash
# pip installs the wheel of the built package, without downloads, and Python renders with it.
# Usage: wheel_test.sh PYTHON BUILD
set -euo pipefail
python=$1 build=$2 root=$(cd "$(dirname "$0")/../../.." && pwd)
"$python" -m pip --version >/dev/null 2>&1 || { echo "pip is missing: skipped"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
wheel=$("$python" -B "$root/packaging/python/asos_build.py" "$build/python/asos" "$folder")
"$python" -m pip install --quiet --no-index --no-deps --target "$folder/site" "$wheel"
cd "$folder"
[[ $(PYTHONPATH=$folder/site "$python" -c '
import asos
picture = asos.load("builtin:boxes").render(width=32, height=18)
print(asos.__file__, picture["beauty"].shape)') == "$folder/site/asos/__init__.py (18, 32, 3)" ]]
installed=$("$python" -m pip list --path "$folder/site" --format freeze 2>/dev/null)
version=$(sed -n 's/^project(asos VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
[[ $installed == "asos==$version" ]] || { echo "pip lists $installed, not asos==$version"; exit 1; }
# A package without its compiled module makes no wheel.
mkdir "$folder/empty"
! "$python" -B "$root/packaging/python/asos_build.py" "$folder/empty" "$folder" 2>/dev/null ||
  { echo "an empty package became a wheel"; exit 1; }
