#!/usr/bin/env bash
# The GGX lobe and Schlick's Fresnel term are written once, in renderer/shading/ggx.h. Finds copies
# by the expressions that each form of them needs. Usage: formulas_test.sh SOURCE_DIR
set -euo pipefail
export LC_ALL=C
cd -- "$1"

# A fifth power: as a product of squares, of five factors, or by pow.
fifth='\bm2 *\* *m2\b|Mul\(m2, m2\)|squared?\(squared?\(|pow\([^;]*[, ]5(\.0f?)?\)|\b(?<m>[a-z_]+)( \* \k<m>){4}\b'
# 1 - alpha^2 in the distribution and in Smith's root; the determinant of an anisotropic lobe; a
# squared sum of slopes; the map from the disk to visible normals.
alpha='(a2|alpha2_?) - 1\.|1\.0f? - (a2|alpha2_?)\b|Sub\(a2, one\)|Sub\(one, a2\)'
slopes='xx_? \* yy_? - xy_? \* xy_?|Mul\((lobe\.)?xx, (lobe\.)?yy\)|slopes \* slopes|square\(slopes'
normals='max\([^;]*, 1(\.0f?)? - x \* x( - y \* y)?\)|Sub\(one, hn::Mul\(p\.x, p\.x\)\)'
formulas="$fifth|$alpha|$slopes|$normals"

# copies_in FILE...: the lines of code with one of the formulas, without comments.
copies_in() {
  { grep -nP -- "$formulas" "$@" /dev/null || true; } |
    awk '{ code = $0; sub(/^[^:]*:[0-9]+:/, "", code); sub(/\/\/.*/, "", code); print $0 "\t" code }' |
    { grep -P -- "\t.*($formulas)" || true; } | cut -f 1
}

# One line of each form; each must be found. A comment must not.
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cat >"$work/forms" <<'FORMS'
return m2 * m2 * m;
const auto fresnel = hn::Mul(hn::Mul(m2, m2), m);
return {lobe, hn::Mul(square(square(m)), m)};
return f0 + (T(1.0f) - f0) * (squared(squared(m)) * m);
const float schlick = m * m * m * m * m;
return x * x * x * x * x;
const float grazing = std::pow(1.0f - along, 5.0f);
const float d = n_dot_h * n_dot_h * (a2 - 1.0f) + 1.0f;
const auto root = [a2](double z) { return std::sqrt(z * z * (1.0 - a2) + a2); };
viewer_root_ = std::sqrt(n_dot_v_ * n_dot_v_ * (1.0f - alpha2_) + alpha2_);
const auto left = hn::Sub(one, a2);
const float det = xx_ * yy_ - xy_ * xy_;
const auto det = hn::Sub(hn::Mul(lobe.xx, lobe.yy), hn::Mul(lobe.xy, lobe.xy));
const float distribution = inv_pi / (alpha.x * alpha.y * slopes * slopes);
const float up = std::sqrt(std::max(0.0f, 1.0f - x * x - y * y));
const auto beside = hn::Max(zero, hn::Sub(one, hn::Mul(p.x, p.x)));
FORMS
cp "$work/forms" "$work/all"
echo '// As m * m * m * m * m.' >>"$work/all"
found=$(copies_in "$work/all" | wc -l)
if ((found != $(wc -l <"$work/forms"))); then
  printf 'of %d known forms only these are found:\n' "$(wc -l <"$work/forms")"
  copies_in "$work/all"
  exit 1
fi

mapfile -t sources < <(find renderer -name '*.h' -o -name '*.cpp' | grep -vx renderer/shading/ggx.h)
if ((${#sources[@]} < 100)); then
  echo "only ${#sources[@]} sources found: this test looks in the wrong place"
  exit 1
fi
copies=$(copies_in "${sources[@]}")
if [[ -n $copies ]]; then
  echo 'GGX and Schlick are written in renderer/shading/ggx.h alone; use its templates in:'
  printf '%s\n' "$copies"
  exit 1
fi
[[ -n $(copies_in renderer/shading/ggx.h) ]] || { echo 'ggx.h has none of the formulas'; exit 1; }
echo "GGX and Schlick's Fresnel term are written once in ${#sources[@]} sources"
