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
  Lanes x, y;
};
HWY_INLINE Pair scaled(Lanes s, const Pair& p) {
  return {hn::Mul(s, p.x), hn::Mul(s, p.y)};
}
HWY_INLINE Lanes dot(const Pair& a, const Pair& b) {
  return hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y));
}
HWY_INLINE Lanes length(const Pair& p) {
  return hn::Sqrt(dot(p, p));
}
HWY_INLINE Pair select(const LaneMask& mask, const Pair& yes, const Pair& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y)};
}

/// As TexelPatch, with the lengths of its edges.
struct PatchLanes {
  Pair right, down;
  Lanes right_length, down_length;

  HWY_INLINE PatchLanes(const Pair& r, const Pair& d)
      : right(r), down(d), right_length(length(r)), down_length(length(d)) {}

  [[nodiscard]] HWY_INLINE Lanes longest() const { return hn::Max(right_length, down_length); }
  [[nodiscard]] HWY_INLINE Lanes area() const {
    return hn::Abs(hn::Sub(hn::Mul(right.x, down.y), hn::Mul(right.y, down.x)));
  }
  /// About how many texels it covers.
  [[nodiscard]] HWY_INLINE Lanes held() const {
    const auto two = all_lanes(2.0f);
    return hn::Mul(hn::Add(right_length, two), hn::Add(down_length, two));
  }
};
HWY_INLINE PatchLanes select(const LaneMask& mask, const PatchLanes& yes, const PatchLanes& no) {
  PatchLanes chosen = no;
  chosen.right = select(mask, yes.right, no.right);
  chosen.down = select(mask, yes.down, no.down);
  chosen.right_length = hn::IfThenElse(mask, yes.right_length, no.right_length);
  chosen.down_length = hn::IfThenElse(mask, yes.down_length, no.down_length);
  return chosen;
}

/// As the function of the same name for one patch.
HWY_INLINE PatchLanes principal_axes(const PatchLanes& p) {
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f), halved = all_lanes(0.5f);
  const auto xx = hn::Add(hn::Mul(p.right.x, p.right.x), hn::Mul(p.down.x, p.down.x));
  const auto yy = hn::Add(hn::Mul(p.right.y, p.right.y), hn::Mul(p.down.y, p.down.y));
  const auto xy = hn::Add(hn::Mul(p.right.x, p.right.y), hn::Mul(p.down.x, p.down.y));
  const auto half = hn::Mul(halved, hn::Sub(xx, yy));
  const auto root = hn::Sqrt(hn::Add(hn::Mul(half, half), hn::Mul(xy, xy)));
  const Pair axis =
      select(hn::Gt(half, zero), Pair{hn::Add(half, root), xy}, Pair{xy, hn::Sub(root, half)});
  const auto size = length(axis);
  const auto some = hn::Gt(size, zero);
  const auto divisor = hn::IfThenElse(some, size, one);
  const Pair unit =
      select(some, Pair{hn::Div(axis.x, divisor), hn::Div(axis.y, divisor)}, Pair{one, zero});
  const auto longer = hn::Sqrt(hn::Add(hn::Mul(halved, hn::Add(xx, yy)), root));
  const auto long_enough = hn::Gt(longer, zero);
  const auto shorter =
      hn::IfThenElseZero(long_enough, hn::Div(p.area(), hn::IfThenElse(long_enough, longer, one)));
  return {scaled(longer, unit), scaled(shorter, Pair{hn::Neg(unit.y), unit.x})};
}

/// Shortens an edge as the function of the same name does; `per_square` is 2 over the squared size
/// of the level's texels.
HWY_INLINE Pair less_of_texels(const Pair& edge, Lanes per_square) {
  const auto length2 = dot(edge, edge);
  const auto some = hn::Gt(length2, all_lanes(1e-30f));
  const auto left2 = hn::Sub(hn::Add(length2, per_square), all_lanes(3.0f));
  const auto least = hn::Max(left2, all_lanes(thinnest_patch * thinnest_patch));
  const auto by = hn::Sqrt(hn::Div(least, hn::IfThenElse(some, length2, all_lanes(1.0f))));
  return {hn::IfThenElseZero(some, hn::Mul(edge.x, by)),
          hn::IfThenElseZero(some, hn::Mul(edge.y, by))};
}

/// Bounds the lengths of both edges as the function of the same name for one patch.
HWY_INLINE PatchLanes bounded(const PatchLanes& patch, Lanes least, Lanes most) {
  const auto one = all_lanes(1.0f);
  const auto longest = hn::IfThenElse(hn::Gt(patch.held(), most), hn::Sqrt(most), most);
  const auto within = [&](const Pair& edge, Lanes size, const Pair& other, Lanes other_size)
                          HWY_ATTR {
                            const auto by = hn::Min(one, hn::Div(longest, hn::Max(size, least)));
                            const auto across = hn::Div(least, other_size);
                            return select(hn::Ge(size, least), scaled(by, edge),
                                          scaled(across, Pair{hn::Neg(other.y), other.x}));
                          };
  const auto right_first = hn::Ge(patch.right_length, patch.down_length);
  const Pair longer = select(right_first, patch.right, patch.down);
  const Pair shorter = select(right_first, patch.down, patch.right);
  const auto longer_size = hn::Max(patch.right_length, patch.down_length);
  const auto shorter_size = hn::Min(patch.right_length, patch.down_length);
  const Pair second = within(shorter, shorter_size, longer, longer_size);
  const Pair first = within(longer, longer_size, second, length(second));
  return {select(right_first, first, second), select(right_first, second, first)};
}

/// The levels of patches from i on, and the patches in them, as patch_in finds them.
HWY_INLINE void find_levels(const TextureGrid& texture, PatchLanes patch, Lanes whole_side,
                            TextureBatch& batch, std::size_t i) {
  const FloatTag d;
  const auto zero = hn::Zero(d), one = all_lanes(1.0f);
  const bool nearest = texture.filter == Filter::nearest;
  const auto squares = hn::Add(dot(patch.right, patch.right), dot(patch.down, patch.down));
  const auto longest = patch.longest();
  const auto smallest = all_lanes(nearest ? least_nearest_footprint : least_footprint);
  const auto wide = hn::And(hn::And(hn::Gt(longest, smallest), hn::Lt(squares, hn::Inf(d))),
                            hn::FirstN(d, batch.count - i));
  if (texture.levels == 0 || hn::AllFalse(d, wide)) {
    store(all_lanes(-1.0f), batch.level, i);
    return;
  }
  // Other lanes have a patch that ends the search at once.
  patch = select(wide, patch, PatchLanes(Pair{one, zero}, Pair{zero, one}));
  const auto too_long = hn::Gt(patch.longest(), all_lanes(longest_patch_edge));
  if (!hn::AllFalse(d, too_long)) {
    const auto shorter = hn::Div(all_lanes(longest_patch_edge), patch.longest());
    patch = select(too_long, PatchLanes(scaled(shorter, patch.right), scaled(shorter, patch.down)),
                   patch);
  }
  const auto rectangle = hn::Mul(hn::Mul(all_lanes(0.5f), patch.right_length), patch.down_length);
  const auto oblique = hn::Lt(patch.area(), rectangle);
  if (!hn::AllFalse(d, oblique)) patch = select(oblique, principal_axes(patch), patch);

  const auto side = hn::Min(whole_side, one);
  const auto across = hn::Max(one, hn::Mul(side, all_lanes(TexelBudget().across)));
  const auto most = hn::Max(all_lanes(TexelBudget::fewest),
                            hn::Mul(hn::Mul(side, side), all_lanes(TexelBudget().most)));
  PatchLanes found = patch;
  auto level = zero, per_square = zero;
  auto goes_on = wide;
  for (std::size_t k = 1; k <= texture.levels; ++k) {
    const glm::vec2 scale = scale_of_level(k, texture.width, texture.height);
    const auto in_x = all_lanes(scale.x), in_y = all_lanes(scale.y);
    const PatchLanes coarser(Pair{hn::Mul(in_x, patch.right.x), hn::Mul(in_y, patch.right.y)},
                             Pair{hn::Mul(in_x, patch.down.x), hn::Mul(in_y, patch.down.y)});
    const auto width = hn::Min(coarser.right_length, coarser.down_length);
    const auto ends = hn::And(hn::Lt(width, across), hn::Le(found.held(), most));
    goes_on = hn::AndNot(ends, goes_on);
    if (hn::AllFalse(d, goes_on)) break;
    found = select(goes_on, coarser, found);
    level = hn::IfThenElse(goes_on, all_lanes(static_cast<float>(k)), level);
    const float texels = std::ldexp(1.0f, static_cast<int>(k));
    per_square = hn::IfThenElse(goes_on, all_lanes(2.0f / (texels * texels)), per_square);
  }
  const auto in_image = hn::Eq(level, zero);
  const PatchLanes narrowed(less_of_texels(found.right, per_square),
                            less_of_texels(found.down, per_square));
  found = select(in_image, found, narrowed);
  const float thinnest_in_image = nearest ? 0.1f * least_nearest_footprint : thinnest_patch;
  const auto least =
      hn::IfThenElse(in_image, all_lanes(thinnest_in_image), all_lanes(thinnest_patch));
  found = bounded(found, least, most);
  store(hn::IfThenElse(wide, level, all_lanes(-1.0f)), batch.level, i);
  store(found.right.x, batch.patch.right_x, i);
  store(found.right.y, batch.patch.right_y, i);
  store(found.down.x, batch.patch.down_x, i);
  store(found.down.y, batch.patch.down_y, i);
}

void find_patches(const TextureGrid& texture, TextureBatch& batch) {
  const FloatTag d;
  const glm::mat3& m = texture.uv_transform;
  const auto turned = [&](const Pair& p) HWY_ATTR {
    return Pair{hn::Add(hn::Mul(all_lanes(m[0].x), p.x), hn::Mul(all_lanes(m[1].x), p.y)),
                hn::Add(hn::Mul(all_lanes(m[0].y), p.x), hn::Mul(all_lanes(m[1].y), p.y))};
  };
  const auto width = all_lanes(static_cast<float>(texture.width));
  const auto height = all_lanes(static_cast<float>(texture.height));
  for (std::size_t i = 0; i < batch.count; i += hn::Lanes(d)) {
    const Pair at_0{loaded(batch.u_0, i), loaded(batch.v_0, i)};
    const Pair at_1{loaded(batch.u_1, i), loaded(batch.v_1, i)};
    const Pair at_2{loaded(batch.u_2, i), loaded(batch.v_2, i)};
    const auto b1 = loaded(batch.b1, i), b2 = loaded(batch.b2, i);
    const auto b0 = hn::Sub(hn::Sub(all_lanes(1.0f), b1), b2);
    const auto mix = [&](Lanes a, Lanes b, Lanes c) HWY_ATTR {
      return hn::Add(hn::Add(hn::Mul(b0, a), hn::Mul(b1, b)), hn::Mul(b2, c));
    };
    const Pair uv = turned({mix(at_0.x, at_1.x, at_2.x), mix(at_0.y, at_1.y, at_2.y)});
    store(hn::Add(uv.x, all_lanes(m[2].x)), batch.u, i);
    store(hn::Add(uv.y, all_lanes(m[2].y)), batch.v, i);
    const Pair by_1{hn::Sub(at_1.x, at_0.x), hn::Sub(at_1.y, at_0.y)};
    const Pair by_2{hn::Sub(at_2.x, at_0.x), hn::Sub(at_2.y, at_0.y)};
    const auto step = [&](Lanes along_1, Lanes along_2) HWY_ATTR {
      const Pair moved = turned({hn::Add(hn::Mul(along_1, by_1.x), hn::Mul(along_2, by_2.x)),
                                 hn::Add(hn::Mul(along_1, by_1.y), hn::Mul(along_2, by_2.y))});
      return Pair{hn::Mul(width, moved.x), hn::Mul(height, moved.y)};
    };
    const TextureBatch::Edges& f = batch.footprint;
    const auto times = texture.widened ? loaded(batch.colours, i) : all_lanes(1.0f);
    const auto edge = [&](const TextureBatch::Floats& x, const TextureBatch::Floats& y) HWY_ATTR {
      return step(hn::Mul(times, loaded(x, i)), hn::Mul(times, loaded(y, i)));
    };
    const PatchLanes patch(edge(f.right_x, f.right_y), edge(f.down_x, f.down_y));
    find_levels(texture, patch, hn::Mul(times, loaded(batch.side, i)), batch, i);
  }
}

/// As the texture filter's Axis: a coordinate in texels.
HWY_INLINE Lanes place_in_texels(Wrap wrap, Lanes u, Lanes size) {
  const auto zero = hn::Zero(FloatTag());
  u = hn::IfThenElseZero(hn::Lt(hn::Abs(u), hn::Inf(FloatTag())), u);
  if (wrap == Wrap::repeat) u = hn::Sub(u, hn::Floor(u));
  if (wrap == Wrap::mirrored_repeat) {
    const auto whole = hn::Floor(hn::Mul(all_lanes(0.5f), u));
    u = hn::Sub(u, hn::Add(whole, whole));
  }
  const auto at = hn::Sub(hn::Mul(u, size), all_lanes(0.5f));
  const auto outside = all_lanes(2.0f * TexelBudget().most);
  return clamped(at, hn::Sub(zero, outside), hn::Add(hn::Add(size, size), outside));
}

/// As TexelWindow for interpolated texels.
struct WindowLanes {
  Pair centre, across_right, across_down;
  Pair wide, reach;
  Lanes height;

  HWY_INLINE WindowLanes(const Pair& at, const Pair& right, const Pair& down) : centre(at) {
    const auto half = all_lanes(0.5f);
    const auto per_area =
        hn::Div(all_lanes(1.0f), hn::Sub(hn::Mul(right.x, down.y), hn::Mul(right.y, down.x)));
    across_right = scaled(per_area, Pair{down.y, hn::Neg(down.x)});
    across_down = scaled(per_area, Pair{hn::Neg(right.y), right.x});
    wide = {length(across_right), length(across_down)};
    reach = {hn::Add(half, wide.x), hn::Add(half, wide.y)};
    height = hn::Add(hn::Mul(reach.x, hn::Abs(right.y)), hn::Mul(reach.y, hn::Abs(down.y)));
  }

  struct Range {
    Lanes low, high;
  };
  /// The x, relative to the centre, within reach of an edge in a row.
  static HWY_INLINE Range range(const Pair& gradient, Lanes reach, Lanes dy) {
    const auto middle = hn::Mul(gradient.y, dy);
    const auto level = hn::Eq(gradient.x, hn::Zero(FloatTag()));
    const auto beyond = hn::Ge(hn::Abs(middle), reach);
    const auto divisor = hn::IfThenElse(level, all_lanes(1.0f), gradient.x);
    const auto a = hn::Div(hn::Sub(hn::Neg(reach), middle), divisor);
    const auto b = hn::Div(hn::Sub(reach, middle), divisor);
    const auto whole = all_lanes(1e30f), one = all_lanes(1.0f);
    return {hn::IfThenElse(level, hn::IfThenElse(beyond, one, hn::Neg(whole)), hn::Min(a, b)),
            hn::IfThenElse(level, hn::IfThenElse(beyond, hn::Neg(one), whole), hn::Max(a, b))};
  }
  [[nodiscard]] HWY_INLINE Range row(Lanes dy) const {
    const Range by_right = range(across_right, reach.x, dy),
                by_down = range(across_down, reach.y, dy);
    return {hn::Max(by_right.low, by_down.low), hn::Min(by_right.high, by_down.high)};
  }
  [[nodiscard]] HWY_INLINE Lanes weight(const Pair& off) const {
    return hn::Mul(share(dot(across_right, off), wide.x), share(dot(across_down, off), wide.y));
  }

 private:
  static HWY_INLINE Lanes below(Lanes t) {
    const auto one = all_lanes(1.0f), half = all_lanes(0.5f);
    t = clamped(t, hn::Neg(one), one);
    return hn::Sub(hn::Add(half, t), hn::Mul(hn::Mul(half, t), hn::Abs(t)));
  }
  static HWY_INLINE Lanes share(Lanes at, Lanes width) {
    const auto half = all_lanes(0.5f);
    return hn::Sub(below(hn::Div(hn::Sub(half, at), width)),
                   below(hn::Div(hn::Sub(hn::Neg(half), at), width)));
  }
};

HWY_INLINE int largest_of(Lanes values) {
  return static_cast<int>(hn::GetLane(hn::MaxOfLanes(FloatTag(), values)));
}

void find_weights(const TextureGrid& texture, const PatchBatch& batch, TexelWeights& weights) {
  const FloatTag d;
  const std::size_t lanes = hn::Lanes(d);
  constexpr int most_rows = 64;
  HWY_ALIGN float begins[most_rows * most_lanes];
  HWY_ALIGN float ends[most_rows * most_lanes];
  weights.clear(lanes, batch.count);
  const auto zero = hn::Zero(d), one = all_lanes(1.0f);
  for (std::size_t i = 0; i < batch.count; i += lanes) {
    const auto used = hn::FirstN(d, batch.count - i);
    const Pair right =
        select(used, Pair{loaded(batch.patch.right_x, i), loaded(batch.patch.right_y, i)},
               Pair{one, zero});
    const Pair down = select(
        used, Pair{loaded(batch.patch.down_x, i), loaded(batch.patch.down_y, i)}, Pair{zero, one});
    const Pair centre{place_in_texels(texture.wrap_u, loaded(batch.u, i), loaded(batch.width, i)),
                      place_in_texels(texture.wrap_v, loaded(batch.v, i), loaded(batch.height, i))};
    const WindowLanes window(centre, right, down);
    const auto first = hn::Add(hn::Floor(hn::Sub(centre.y, window.height)), one);
    const auto last = hn::Floor(hn::Add(centre.y, window.height));
    // Lanes without numbers have no rows, as in TexelWindow. Neither have rows beyond a patch,
    // whose ends may be infinite.
    const auto high = hn::Add(hn::Sub(last, first), one);
    const auto numbers = hn::And(used, hn::Ge(high, zero));
    const int rows = std::clamp(largest_of(hn::IfThenElseZero(numbers, high)), 0, most_rows);
    auto widest = zero;
    for (int r = 0; r < rows; ++r) {
      const auto y = hn::Add(first, all_lanes(static_cast<float>(r)));
      const WindowLanes::Range range = window.row(hn::Sub(y, centre.y));
      const auto begin = hn::Add(hn::Floor(hn::Add(centre.x, range.low)), one);
      const auto end = hn::Floor(hn::Add(centre.x, range.high));
      const auto some = hn::And(used, hn::And(hn::Le(y, last), hn::Le(begin, end)));
      const auto kept_end = hn::IfThenElse(some, end, hn::Sub(begin, one));
      const auto at = static_cast<std::size_t>(r) * most_lanes;
      hn::Store(begin, d, begins + at);
      hn::Store(kept_end, d, ends + at);
      widest = hn::Max(widest, hn::IfThenElseZero(some, hn::Add(hn::Sub(kept_end, begin), one)));
    }
    const int columns = largest_of(widest);
    float* out = weights.add_group(rows, columns);
    hn::StoreU(first, d, out);
    out += lanes;
    for (int r = 0; r < rows; ++r, out += lanes)
      hn::StoreU(hn::Load(d, begins + static_cast<std::size_t>(r) * most_lanes), d, out);
    for (int r = 0; r < rows; ++r) {
      const auto at = static_cast<std::size_t>(r) * most_lanes;
      const auto begin = hn::Load(d, begins + at), end = hn::Load(d, ends + at);
      const auto dy = hn::Sub(hn::Add(first, all_lanes(static_cast<float>(r))), centre.y);
      for (int c = 0; c < columns; ++c, out += lanes) {
        const auto x = hn::Add(begin, all_lanes(static_cast<float>(c)));
        const auto weight = window.weight({hn::Sub(x, centre.x), dy});
        hn::StoreU(hn::IfThenElseZero(hn::Le(x, end), weight), d, out);
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
