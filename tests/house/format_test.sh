#!/usr/bin/env bash
# Every source is formatted by clang-format with the settings of the tree.
# Usage: format_test.sh SOURCE_DIR. Exit code 77: skipped, this clang-format is not installed.
set -euo pipefail
cd -- "$1"
command -v clang-format-14 >/dev/null || {
  echo 'skipped: clang-format-14 is not installed'
  exit 77
}
find app examples include renderer ui tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 -r clang-format-14 --dry-run --Werror --ferror-limit=3
