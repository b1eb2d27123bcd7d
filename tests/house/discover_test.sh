#!/usr/bin/env bash
# CTest's result for a suite: passed, failed, skipped, and failed although no test passed.
# Usage: discover_test.sh SOURCE_DIR
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# A program with GoogleTest's output.
cat > "$folder/program" <<'PROGRAM'
#!/bin/sh
case $1 in
  --gtest_list_tests) printf 'Running main()\nPasses.\n  A\nFails.\n  A\nSkips.\n  A\nBoth.\n  A\n  B\n' ;;
  *Passes*) printf '[  PASSED  ] 1 test.\n' ;;
  *Fails*) printf '[  PASSED  ] 0 tests.\n[  FAILED  ] 1 test, listed below:\n[  FAILED  ] Fails.A\n\n 1 FAILED TEST\n'; exit 1 ;;
  *Skips*) printf '[  PASSED  ] 0 tests.\n[  SKIPPED ] 1 test, listed below:\n[  SKIPPED ] Skips.A\n' ;;
  *Both*) printf '[  PASSED  ] 0 tests.\n[  SKIPPED ] 1 test, listed below:\n[  SKIPPED ] Both.A\n[  FAILED  ] 1 test, listed below:\n[  FAILED  ] Both.B\n\n 1 FAILED TEST\n'; exit 1 ;;
esac
PROGRAM
chmod +x "$folder/program"
cat > "$folder/CTestTestfile.cmake" <<LIST
set(program "$folder/program")
set(prefix "tried.")
set(timeout 60)
set(found "$folder/found.cmake")
include("$1/third_party/cmake/DiscoverSuites.cmake")
LIST
said=$(cd "$folder" && ctest 2>&1 || true)
for line in 'tried.Passes .*   Passed' 'tried.Fails .*\*\*\*Failed' 'tried.Skips .*\*\*\*Skipped' \
  'tried.Both .*\*\*\*Failed'; do
  grep -q "$line" <<< "$said" || {
    echo "no line '$line' in:"
    echo "$said"
    exit 1
  }
done
