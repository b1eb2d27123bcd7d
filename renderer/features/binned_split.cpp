#include "renderer/features/binned_split.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace asos {
namespace {

constexpr int bin_count = 16;

// Four floats at a time, in the vectors that GCC and Clang offer on all processors. The fourth is
// not used.
using Floats = float __attribute__((vector_size(4 * sizeof(float))));

struct FastBox {
  Floats lo = Floats{} + std::numeric_limits<float>::infinity();
  Floats hi = Floats{} - std::numeric_limits<float>::infinity();

  void grow(const FastBox& b) {
    lo = b.lo < lo ? b.lo : lo;
    hi = b.hi > hi ? b.hi : hi;
  }
  void grow(Floats p) { grow(FastBox{p, p}); }
};

FastBox fast_box(const EdgeItem& item) {
  static_assert(offsetof(Box, hi) == 3 * sizeof(float));
  // Load four numbers each: `lo` and the next number, and `hi` with the number before it. Both
  // loads stay within the box.
  FastBox fast;
  std::memcpy(&fast.lo, &item.box.lo.x, sizeof fast.lo);
  std::memcpy(&fast.hi, &item.box.lo.z, sizeof fast.hi);
  fast.hi = __builtin_shufflevector(fast.hi, fast.hi, 1, 2, 3, 0);
  return fast;
}

// Returns twice the centre.
Floats centre(const EdgeItem& item) {
  const FastBox fast = fast_box(item);
  return fast.lo + fast.hi;
}

float extent_sum(const FastBox& box) {
  const Floats d = box.hi - box.lo;
  return d[0] + d[1] + d[2];
}

std::pair<EdgeItems, EdgeItems> halves(EdgeItems items) {
  return {items.first(items.size() / 2), items.subspan(items.size() / 2)};
}

}  // namespace

std::pair<EdgeItems, EdgeItems> binned_split(EdgeItems items) {
  FastBox centres;
  for (const EdgeItem& i : items) centres.grow(centre(i));
  const Floats size = centres.hi - centres.lo;
  const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
  const float scale = static_cast<float>(bin_count) / size[axis];
  const auto bin_of = [&](const EdgeItem& i) {
    const float b = (centre(i)[axis] - centres.lo[axis]) * scale;
    return std::clamp(static_cast<int>(b), 0, bin_count - 1);
  };
  if (!(size[axis] > 0.0f) || !std::isfinite(scale)) return halves(items);

  struct Bin {
    FastBox box;
    std::size_t count = 0;
  };
  std::array<Bin, bin_count> bins;
  for (const EdgeItem& i : items) {
    Bin& bin = bins[static_cast<std::size_t>(bin_of(i))];
    bin.box.grow(fast_box(i));
    ++bin.count;
  }
  std::array<float, bin_count> cost_right{};
  Bin swept;
  for (int b = bin_count - 1; b > 0; --b) {
    const auto at = static_cast<std::size_t>(b);
    swept.box.grow(bins[at].box);
    swept.count += bins[at].count;
    cost_right[at] = swept.count ? extent_sum(swept.box) * static_cast<float>(swept.count) : 0;
  }
  swept = {};
  int best = -1;
  float best_cost = std::numeric_limits<float>::infinity();
  for (int b = 0; b + 1 < bin_count; ++b) {
    const auto at = static_cast<std::size_t>(b);
    swept.box.grow(bins[at].box);
    swept.count += bins[at].count;
    if (swept.count == 0 || swept.count == items.size()) continue;
    const float cost = extent_sum(swept.box) * static_cast<float>(swept.count) + cost_right[at + 1];
    if (cost < best_cost) best_cost = cost, best = b;
  }
  if (best < 0) return halves(items);
  const auto middle = std::partition(items.begin(), items.end(),
                                     [&](const EdgeItem& i) { return bin_of(i) <= best; });
  const auto count = static_cast<std::size_t>(middle - items.begin());
  return {items.first(count), items.subspan(count)};
}

}  // namespace asos
