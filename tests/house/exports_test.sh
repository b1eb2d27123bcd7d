#!/usr/bin/env bash
# The shared library exports what tests/house/exports.txt lists and nothing else: a program that was linked
# with it finds its symbols in the next one. A line that goes, or changes, asks for another SOVERSION.
# Usage: exports_test.sh LIBRARY LIST. To renew the list: UPDATE=1 exports_test.sh LIBRARY LIST.
set -euo pipefail
export LC_ALL=C
library=$1 list=$2
# Constructors and destructors have several symbols of one name.
exported=$(nm -D --defined-only -C "$library" | sed -E 's/^[0-9a-f]* [A-Za-z] //' | sort -u)
[[ -z ${UPDATE-} ]] || printf '%s\n' "$exported" >"$list"
diff -u "$list" <(printf '%s\n' "$exported") || {
  echo "$library exports other symbols than $list lists (-: missing, +: new)"
  exit 1
}
wrong=$(grep -vE '^asos::api::' <<<"$exported" || true)
[[ -z $wrong ]] || {
  printf 'these symbols are not of the public interface:\n%s\n' "$wrong"
  exit 1
}
echo "$(wc -l <"$list") symbols, as listed"
