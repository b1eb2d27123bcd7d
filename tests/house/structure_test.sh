#!/usr/bin/env bash
# Structure of the code: one type Pyray, no hidden state in the casters, no class of the engine
# above its size limit, no new tuning constants, and an architecture document whose path of a pixel
# names existing functions.
# Usage: structure_test.sh SOURCE_DIR
set -euo pipefail
export LC_ALL=C
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
cd -- "$1"
status=0
fail() {
  status=1
  printf '%s\n' "$@"
}

most_functions=25
most_lines=400
folders=(pyray asos shadows reflections)
# Larger classes that are allowed, each with its reason.
exceptions=()

# sizes_of FILE...: the output of class_sizes.awk; headers come first, so that it knows the classes.
sizes_of() {
  local headers=() sources=() file
  for file in "$@"; do
    if [[ $file == *.h ]]; then headers+=("$file"); else sources+=("$file"); fi
  done
  awk -f "$here/class_sizes.awk" "${headers[@]}" "${sources[@]}"
}

# Tests the counting itself with a class of known size.
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cat >"$work/sample.h" <<'SAMPLE'
namespace asos {
class Forward;
/// Not { a brace, nor a function().
class Sample final : public Base {
 public:
  explicit Sample(int a, const Options& options = {}) : a_{a}, b_(2), c_{3, {4}} { go(); }
  Sample(const Sample&) = delete;
  Sample& operator=(const Sample&) = delete;
  bool operator()(int x) const { return x == 1'000; }
  template <typename F>
  [[nodiscard]] std::function<void(int)> with(const F& f,
                                              int n = 3);
  struct Inner {
    int value = f(2);
    [[nodiscard]] int twice() const { return 2 * value; }
  };
  virtual void pure() = 0;
  friend bool same(const Sample&, const Sample&);
  using Call = void (*)(int);

 private:
  enum class Kind { a, b };
  std::function<bool(const Sample&)> ask_;
  void (*pointer_)(int) = nullptr;
  const char* text_ = "} (";
  char brace_ = '{';
  std::array<int, 3> numbers_{1, 2, 3};
  const Options& options_;
  int a_, b_, c_;
};
}  // namespace asos
SAMPLE
cat >"$work/sample.cpp" <<'SAMPLE'
namespace {
struct Sample2 {
  void one();
};
void Sample2::one() {}
}  // namespace
std::function<void(int)> Sample::with(const F& f, int n) {
  if (n) {
    f();
  }
  return {};
}
int Sample::Inner::other() { return 0; }
SAMPLE
counted=$(sizes_of "$work/sample.cpp" "$work/sample.h" | sed "s: $work/: :" | sort)
expected='class Sample 6 33 sample.h
class Sample2 1 4 sample.cpp
class Sample::Inner 1 5 sample.h
reference Sample 28 sample.h'
[[ $counted == "$expected" ]] ||
  fail 'class_sizes.awk miscounts; expected and counted:' "$expected" "$counted"

# Exactly one type is called Pyray.
pyrays=$(grep -rnE --include='*.h' --include='*.cpp' \
  '(^|[^A-Za-z_])((struct|class|union)[[:space:]]+Pyray([[:space:]]*$|[[:space:]]*[:{]|[[:space:]]+final)|using[[:space:]]+Pyray[[:space:]]*=)' \
  app renderer ui tests || true)
[[ $(cut -d: -f1 <<<"$pyrays") == renderer/pyray/pyray.h ]] ||
  fail 'there has to be one type Pyray, in renderer/pyray/pyray.h; found:' "${pyrays:-none}"

# The engine's classes, and the members of its casters.
sources=()
for folder in "${folders[@]}"; do
  mapfile -t found < <(find "renderer/$folder" -name '*.h' -o -name '*.cpp')
  sources+=("${found[@]}")
done
mapfile -t casters < <(find renderer -name '*_caster.h')
sizes=$(sizes_of "${sources[@]}")
(($(grep -c '^class ' <<<"$sizes") >= 20)) || fail 'too few classes found: this test looks wrong'
while read -r _ name functions lines file; do
  ((functions > most_functions || lines > most_lines)) || continue
  [[ " ${exceptions[*]-} " == *" $name "* ]] && continue
  fail "$file: $name has $functions functions and $lines lines, of at most $most_functions and $most_lines"
done < <(grep '^class ' <<<"$sizes")
((${#casters[@]} > 0)) || fail 'no casters found: this test looks wrong'
while read -r _ name line file; do
  fail "$file:$line: $name keeps a reference; a caster is given what it looks at by argument"
done < <(sizes_of "${casters[@]}" | grep '^reference ' || true)
mutable=$(grep -nE '(^|[^A-Za-z_])mutable([^A-Za-z_]|$)' "${casters[@]}" /dev/null |
  sed 's://.*$::' | grep -w mutable || true)
[[ -z $mutable ]] || fail 'casters keep nothing that is mutable:' "$mutable"

# The numbers that trade error for time stand in one table. The others are mathematical, bounds of
# arrays, guards against rounding, or geometry.
table=renderer/pyray/tuning.h
most_in_table=63
most_elsewhere=73
constants=()
for folder in asos pyray shadows samples; do
  mapfile -t found < <(find "renderer/$folder" -name '*.h' -o -name '*.cpp')
  constants+=("${found[@]}")
done
# numbers_of FILE...: its constants of arithmetic types.
numbers_of() {
  grep -hE '(^|[^a-z_])constexpr [a-zA-Z0-9_:]+ [a-z_0-9]+ = ' "$@" |
    grep -vE 'constexpr (auto|bool|Square|glm::[a-z0-9]+) ' || true
}
in_table=$(numbers_of "$table" | grep -c .)
all=$(numbers_of "${constants[@]}" | grep -c .)
((in_table <= most_in_table)) ||
  fail "$table has $in_table constants, of at most $most_in_table: remove one for each new one"
((all - in_table <= most_elsewhere)) ||
  fail "asos, pyray, shadows and samples have $((all - in_table)) numbers outside of $table, of at" \
    "most $most_elsewhere"

# The numbered list of a pixel's path, one entry per line: `function` (`file`).
awk '
  /A pixel.s way/ { inside = 1 }
  inside && /^#/ && !/A pixel.s way/ { exit }
  inside && /^[0-9]+\. / { printf "\n" }
  inside && /^[0-9]+\. /, inside && /^$/ { printf "%s ", $0 }
' docs/architecture.md >"$work/entries"
entries=$(grep -cE '^[0-9]+\. ' "$work/entries" || true)
pairs=$(grep -E '^[0-9]+\. ' "$work/entries" |
  grep -oE '`[A-Za-z_:~]+(\(\))?` +\(`[^`]+`\)' | tr -d '`()' || true)
count=$(grep -c . <<<"$pairs" || true)
((entries <= 12 && count >= 6 && count <= 12)) ||
  fail "docs/architecture.md: \"A pixel's way\" names $count functions in $entries entries; 6 to 12 are wanted"
while read -r function file; do
  [[ -n $function ]] || continue
  if [[ ! -f $file ]]; then
    fail "docs/architecture.md: \"A pixel's way\" names $file, which does not exist"
  elif ! grep -qE "(^|[^A-Za-z_])${function##*::}\(" -- "$file"; then
    fail "docs/architecture.md: \"A pixel's way\" names $function, which $file does not have"
  fi
done <<<"$pairs"

if ((status == 0)); then echo "one Pyray, $(grep -c '^class ' <<<"$sizes") classes of bearable size"; fi
exit $status
