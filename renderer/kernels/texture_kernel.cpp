#include "renderer/kernels/texture_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/texture_kernel.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include "renderer/kernels/lanes.h"
#include "renderer/shading/level_patch.h"

#include <algorithm>
#include <cmath>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

constexpr std::size_t most_lanes = hn::MaxLanes(FloatTag());

struct Pair {
  Lane x, y;
};
HWY_INLINE Pair operator*(Lane s, const Pair& p) {
  return {s * p.x, s * p.y};
}
HWY_INLINE Lane dot(const Pair& a, const Pair& b) {
  return a.x * b.x + a.y * b.y;
}
HWY_INLINE Lane length(const Pair& p) {
  return sqrt(dot(p, p));
}
HWY_INLINE Pair selected(const LaneMask& mask, const Pair& yes, const Pair& no) {
  return {selected(mask, yes.x, no.x), selected(mask, yes.y, no.y)};
}

/// As TexelPatch, with the lengths of its edges.
struct PatchLanes {
  Pair right, down;
  Lane right_length, down_length;

  HWY_INLINE PatchLanes(const Pair& r, const Pair& d)
      : right(r), down(d), right_length(length(r)), down_length(length(d)) {}

  [[nodiscard]] HWY_INLINE Lane longest() const { return max(right_length, down_length); }
  [[nodiscard]] HWY_INLINE Lane area() const { return abs(right.x * down.y - right.y * down.x); }
  /// About how many texels it covers.
  [[nodiscard]] HWY_INLINE Lane held() const {
    return (right_length + 2.0f) * (down_length + 2.0f);
  }
};
HWY_INLINE PatchLanes selected(const LaneMask& mask, const PatchLanes& yes, const PatchLanes& no) {
  PatchLanes chosen = no;
  chosen.right = selected(mask, yes.right, no.right);
  chosen.down = selected(mask, yes.down, no.down);
  chosen.right_length = selected(mask, yes.right_length, no.right_length);
  chosen.down_length = selected(mask, yes.down_length, no.down_length);
  return chosen;
}

/// As the function of the same name for one patch.
HWY_INLINE PatchLanes principal_axes(const PatchLanes& p) {
  constexpr float halved = 0.5f;
  const auto xx = p.right.x * p.right.x + p.down.x * p.down.x;
  const auto yy = p.right.y * p.right.y + p.down.y * p.down.y;
  const auto xy = p.right.x * p.right.y + p.down.x * p.down.y;
  const auto half = halved * (xx - yy);
  const auto root = sqrt(half * half + xy * xy);
  const Pair axis = selected(half > 0.0f, Pair{half + root, xy}, Pair{xy, root - half});
  const auto size = length(axis);
  const auto some = size > 0.0f;
  const auto divisor = selected(some, size, 1.0f);
  const Pair unit = selected(some, Pair{axis.x / divisor, axis.y / divisor}, Pair{1.0f, 0.0f});
  const auto longer = sqrt(halved * (xx + yy) + root);
  const auto long_enough = longer > 0.0f;
  const auto shorter = where(long_enough, p.area() / selected(long_enough, longer, 1.0f));
  return {longer * unit, shorter * Pair{-unit.y, unit.x}};
}

/// Shortens an edge as the function of the same name does; `per_square` is 2 over the squared size
/// of the level's texels.
HWY_INLINE Pair less_of_texels(const Pair& edge, Lane per_square) {
  const auto length2 = dot(edge, edge);
  const auto some = length2 > 1e-30f;
  const auto left2 = length2 + per_square - 3.0f;
  const auto least = max(left2, thinnest_patch * thinnest_patch);
  const auto by = sqrt(least / selected(some, length2, 1.0f));
  return {where(some, edge.x * by), where(some, edge.y * by)};
}

/// Bounds the lengths of both edges as the function of the same name for one patch.
HWY_INLINE PatchLanes bounded(const PatchLanes& patch, Lane least, Lane most) {
  const auto longest = selected(patch.held() > most, sqrt(most), most);
  const auto within = [&](const Pair& edge, Lane size, const Pair& other,
                          Lane other_size) HWY_ATTR {
    const auto by = min(1.0f, longest / max(size, least));
    const auto across = least / other_size;
    return selected(size >= least, by * edge, across * Pair{-other.y, other.x});
  };
  const auto right_first = patch.right_length >= patch.down_length;
  const Pair longer = selected(right_first, patch.right, patch.down);
  const Pair shorter = selected(right_first, patch.down, patch.right);
  const auto longer_size = max(patch.right_length, patch.down_length);
  const auto shorter_size = min(patch.right_length, patch.down_length);
  const Pair second = within(shorter, shorter_size, longer, longer_size);
  const Pair first = within(longer, longer_size, second, length(second));
  return {selected(right_first, first, second), selected(right_first, second, first)};
}

/// The levels of patches from i on, and the patches in them, as patch_in finds them.
HWY_INLINE void find_levels(const TextureGrid& texture, PatchLanes patch, Lane whole_side,
                            TextureBatch& batch, std::size_t i) {
  const bool nearest = texture.filter == Filter::nearest;
  const auto squares = dot(patch.right, patch.right) + dot(patch.down, patch.down);
  const auto longest = patch.longest();
  const auto smallest = nearest ? least_nearest_footprint : least_footprint;
  const auto wide = longest > smallest && squares < infinity && LaneMask::first(batch.count - i);
  if (texture.levels == 0 || none(wide)) {
    store(-1.0f, batch.level, i);
    return;
  }
  // Other lanes have a patch that ends the search at once.
  patch = selected(wide, patch, PatchLanes(Pair{1.0f, 0.0f}, Pair{0.0f, 1.0f}));
  const auto too_long = patch.longest() > longest_patch_edge;
  if (!none(too_long)) {
    const auto shorter = longest_patch_edge / patch.longest();
    patch = selected(too_long, PatchLanes(shorter * patch.right, shorter * patch.down), patch);
  }
  const auto rectangle = 0.5f * patch.right_length * patch.down_length;
  const auto oblique = patch.area() < rectangle;
  if (!none(oblique)) patch = selected(oblique, principal_axes(patch), patch);
  const auto side = min(whole_side, 1.0f);
  const auto across = max(1.0f, side * TexelBudget().across);
  const auto most = max(TexelBudget::fewest, side * side * TexelBudget().most);
  PatchLanes found = patch;
  Lane level = 0.0f, per_square = 0.0f;
  auto goes_on = wide;
  for (std::size_t k = 1; k <= texture.levels; ++k) {
    const glm::vec2 scale = scale_of_level(k, texture.width, texture.height);
    const auto in_x = scale.x, in_y = scale.y;
    const PatchLanes coarser(Pair{in_x * patch.right.x, in_y * patch.right.y},
                             Pair{in_x * patch.down.x, in_y * patch.down.y});
    const auto width = min(coarser.right_length, coarser.down_length);
    const auto ends = width < across && found.held() <= most;
    goes_on = goes_on && !ends;
    if (none(goes_on)) break;
    found = selected(goes_on, coarser, found);
    level = selected(goes_on, static_cast<float>(k), level);
    const float texels = std::ldexp(1.0f, static_cast<int>(k));
    per_square = selected(goes_on, 2.0f / (texels * texels), per_square);
  }
  const auto in_image = level == 0.0f;
  const PatchLanes narrowed(less_of_texels(found.right, per_square),
                            less_of_texels(found.down, per_square));
  found = selected(in_image, found, narrowed);
  const float thinnest_in_image = nearest ? 0.1f * least_nearest_footprint : thinnest_patch;
  const auto least = selected(in_image, thinnest_in_image, thinnest_patch);
  found = bounded(found, least, most);
  store(selected(wide, level, -1.0f), batch.level, i);
  store(found.right.x, batch.patch.right_x, i);
  store(found.right.y, batch.patch.right_y, i);
  store(found.down.x, batch.patch.down_x, i);
  store(found.down.y, batch.patch.down_y, i);
}

void find_patches(const TextureGrid& texture, TextureBatch& batch) {
  const glm::mat3& m = texture.uv_transform;
  const auto turned = [&](const Pair& p) HWY_ATTR {
    return Pair{m[0].x * p.x + m[1].x * p.y, m[0].y * p.x + m[1].y * p.y};
  };
  const auto width = static_cast<float>(texture.width);
  const auto height = static_cast<float>(texture.height);
  for (std::size_t i = 0; i < batch.count; i += Lane::count()) {
    const Pair at_0{loaded(batch.u_0, i), loaded(batch.v_0, i)};
    const Pair at_1{loaded(batch.u_1, i), loaded(batch.v_1, i)};
    const Pair at_2{loaded(batch.u_2, i), loaded(batch.v_2, i)};
    const auto b1 = loaded(batch.b1, i), b2 = loaded(batch.b2, i);
    const auto b0 = 1.0f - b1 - b2;
    const auto mix = [&](Lane a, Lane b, Lane c) HWY_ATTR { return b0 * a + b1 * b + b2 * c; };
    const Pair uv = turned({mix(at_0.x, at_1.x, at_2.x), mix(at_0.y, at_1.y, at_2.y)});
    store(uv.x + m[2].x, batch.u, i);
    store(uv.y + m[2].y, batch.v, i);
    const Pair by_1{at_1.x - at_0.x, at_1.y - at_0.y};
    const Pair by_2{at_2.x - at_0.x, at_2.y - at_0.y};
    const auto step = [&](Lane along_1, Lane along_2) HWY_ATTR {
      const Pair moved =
          turned({along_1 * by_1.x + along_2 * by_2.x, along_1 * by_1.y + along_2 * by_2.y});
      return Pair{width * moved.x, height * moved.y};
    };
    const TextureBatch::Edges& f = batch.footprint;
    const auto times = texture.widened ? loaded(batch.colours, i) : 1.0f;
    const auto edge = [&](const TextureBatch::Floats& x, const TextureBatch::Floats& y)
                          HWY_ATTR { return step(times * loaded(x, i), times * loaded(y, i)); };
    const PatchLanes patch(edge(f.right_x, f.right_y), edge(f.down_x, f.down_y));
    find_levels(texture, patch, times * loaded(batch.side, i), batch, i);
  }
}

/// As the texture filter's Axis: a coordinate in texels.
HWY_INLINE Lane place_in_texels(Wrap wrap, Lane u, Lane size) {
  u = where(abs(u) < infinity, u);
  if (wrap == Wrap::repeat) u = u - floor(u);
  if (wrap == Wrap::mirrored_repeat) {
    const auto whole = floor(0.5f * u);
    u = u - (whole + whole);
  }
  const auto at = u * size - 0.5f;
  const auto outside = 2.0f * TexelBudget().most;
  return clamp(at, -outside, size + size + outside);
}

/// As TexelWindow for interpolated texels.
struct WindowLanes {
  Pair centre, across_right, across_down;
  Pair wide, reach;
  Lane height;

  HWY_INLINE WindowLanes(const Pair& at, const Pair& right, const Pair& down) : centre(at) {
    constexpr float half = 0.5f;
    const auto per_area = 1.0f / (right.x * down.y - right.y * down.x);
    across_right = per_area * Pair{down.y, -down.x};
    across_down = per_area * Pair{-right.y, right.x};
    wide = {length(across_right), length(across_down)};
    reach = {half + wide.x, half + wide.y};
    height = reach.x * abs(right.y) + reach.y * abs(down.y);
  }

  struct Range {
    Lane low, high;
  };
  /// The x, relative to the centre, within reach of an edge in a row.
  static HWY_INLINE Range range(const Pair& gradient, Lane reach, Lane dy) {
    const auto middle = gradient.y * dy;
    const auto level = gradient.x == 0.0f;
    const auto beyond = abs(middle) >= reach;
    const auto divisor = selected(level, 1.0f, gradient.x);
    const auto a = (-reach - middle) / divisor;
    const auto b = (reach - middle) / divisor;
    const auto whole = 1e30f;
    return {selected(level, selected(beyond, 1.0f, -whole), min(a, b)),
            selected(level, selected(beyond, -1.0f, whole), max(a, b))};
  }
  [[nodiscard]] HWY_INLINE Range row(Lane dy) const {
    const Range by_right = range(across_right, reach.x, dy),
                by_down = range(across_down, reach.y, dy);
    return {max(by_right.low, by_down.low), min(by_right.high, by_down.high)};
  }
  [[nodiscard]] HWY_INLINE Lane weight(const Pair& off) const {
    return share(dot(across_right, off), wide.x) * share(dot(across_down, off), wide.y);
  }

 private:
  static HWY_INLINE Lane below(Lane t) {
    constexpr float half = 0.5f;
    t = clamp(t, -1.0f, 1.0f);
    return half + t - half * t * abs(t);
  }
  static HWY_INLINE Lane share(Lane at, Lane width) {
    constexpr float half = 0.5f;
    return below((half - at) / width) - below((-half - at) / width);
  }
};

HWY_INLINE int largest_of(Lane values) {
  return static_cast<int>(hn::GetLane(hn::MaxOfLanes(FloatTag(), values.raw)));
}

void find_weights(const TextureGrid& texture, const PatchBatch& batch, TexelWeights& weights) {
  const std::size_t lanes = Lane::count();
  constexpr int most_rows = 64;
  HWY_ALIGN float begins[most_rows * most_lanes];
  HWY_ALIGN float ends[most_rows * most_lanes];
  weights.clear(lanes, batch.count);
  for (std::size_t i = 0; i < batch.count; i += lanes) {
    const auto used = LaneMask::first(batch.count - i);
    const Pair right =
        selected(used, Pair{loaded(batch.patch.right_x, i), loaded(batch.patch.right_y, i)},
                 Pair{1.0f, 0.0f});
    const Pair down = selected(
        used, Pair{loaded(batch.patch.down_x, i), loaded(batch.patch.down_y, i)}, Pair{0.0f, 1.0f});
    const Pair centre{place_in_texels(texture.wrap_u, loaded(batch.u, i), loaded(batch.width, i)),
                      place_in_texels(texture.wrap_v, loaded(batch.v, i), loaded(batch.height, i))};
    const WindowLanes window(centre, right, down);
    const auto first = floor(centre.y - window.height) + 1.0f;
    const auto last = floor(centre.y + window.height);
    // Lanes without numbers have no rows, as in TexelWindow. Neither have rows beyond a patch,
    // whose ends may be infinite.
    const auto high = last - first + 1.0f;
    const auto numbers = used && high >= 0.0f;
    const int rows = std::clamp(largest_of(where(numbers, high)), 0, most_rows);
    Lane widest = 0.0f;
    for (int r = 0; r < rows; ++r) {
      const auto y = first + static_cast<float>(r);
      const WindowLanes::Range range = window.row(y - centre.y);
      const auto begin = floor(centre.x + range.low) + 1.0f;
      const auto end = floor(centre.x + range.high);
      const auto some = used && y <= last && begin <= end;
      const auto kept_end = selected(some, end, begin - 1.0f);
      const auto at = static_cast<std::size_t>(r) * most_lanes;
      begin.store(begins + at);
      kept_end.store(ends + at);
      widest = max(widest, where(some, kept_end - begin + 1.0f));
    }
    const int columns = largest_of(widest);
    float* out = weights.add_group(rows, columns);
    first.store(out);
    out += lanes;
    for (int r = 0; r < rows; ++r, out += lanes)
      Lane::loaded(begins + static_cast<std::size_t>(r) * most_lanes).store(out);
    for (int r = 0; r < rows; ++r) {
      const auto at = static_cast<std::size_t>(r) * most_lanes;
      const auto begin = Lane::loaded(begins + at), end = Lane::loaded(ends + at);
      const auto dy = first + static_cast<float>(r) - centre.y;
      for (int c = 0; c < columns; ++c, out += lanes) {
        const auto x = begin + static_cast<float>(c);
        const auto weight = window.weight({x - centre.x, dy});
        where(x <= end, weight).store(out);
      }
    }
  }
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(find_patches);
HWY_EXPORT(find_weights);

void find_texture_patches(const TextureGrid& texture, TextureBatch& batch) {
  HWY_DYNAMIC_DISPATCH(find_patches)(texture, batch);
}

void find_texel_weights(const TextureGrid& texture, const PatchBatch& patches,
                        TexelWeights& weights) {
  HWY_DYNAMIC_DISPATCH(find_weights)(texture, patches, weights);
}

}  // namespace asos
#endif
