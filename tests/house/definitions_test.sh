#!/usr/bin/env bash
# No program defines a type twice: that is undefined behaviour which neither compiler nor linker reports.
# Usage: definitions_test.sh SOURCE_DIR. Exit code 77: skipped, there is no python3.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
command -v python3 >/dev/null || {
  echo 'skipped: python3 is not installed'
  exit 77
}
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
export PYTHONDONTWRITEBYTECODE=1

# The script itself, by a tree with one type that is defined twice.
mkdir -p "$work/app" "$work/ui" "$work/tests/app" "$work/tests/ui"
cat >"$work/app/a.h" <<'SAMPLE'
// struct Comment {};
namespace asos {
/// A template, attributes, a base and a nested type.
template <typename T, typename = std::vector<T>>
class [[nodiscard]] Twice final : public Base<T> {
 public:
  struct Inner { int a = 1'000; };
  enum class Kind : int { none };
  const char* text = "struct Text {";
};
struct Once {
  Once() { struct Local {}; }
};
class Declared;
template <>
struct Special<int> {};
}  // namespace asos
SAMPLE
cat >"$work/ui/b.cpp" <<'SAMPLE'
namespace asos::ui {
struct Once {};
}
namespace asos {
namespace {
struct Once {};
}
void f() { struct Local {}; }
struct Declared {};
template <>
struct Special<float> {};
struct Twice {};
}
SAMPLE
# Two programs may each have a type of this name, but none of the program's own.
echo 'namespace asos { struct Fixture {}; }' >"$work/tests/app/c.cpp"
echo 'namespace asos { struct Fixture {}; struct Declared {}; }' >"$work/tests/ui/d.cpp"
found=$(python3 "$here/definitions.py" "$work" || true)
expected='ui/b.cpp:9: asos::Declared is defined in tests/ui/d.cpp:1, too
ui/b.cpp:12: asos::Twice is defined in app/a.h:5, too
12 types, 2 of them defined twice'
[[ $found == "$expected" ]] || {
  printf 'definitions.py is wrong; expected and found:\n%s\n%s\n' "$expected" "$found"
  exit 1
}

found=$(python3 "$here/definitions.py" "$1") || {
  echo "$found"
  exit 1
}
((${found%% *} >= 800)) || {
  echo "only $found: this test looks in the wrong place"
  exit 1
}
echo "$found"
