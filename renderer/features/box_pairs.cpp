#include "renderer/features/box_pairs.h"

#include "renderer/features/stoppable_loop.h"
#include "renderer/tasks.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

// Vectors are passed to inlined functions only, so no calling convention matters.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace asos {
namespace {

constexpr int bits_an_axis = 21;

struct Keyed {
  std::uint64_t code;
  std::uint32_t triangle;
};

// Inserts two zeros between all bits.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

std::uint64_t morton_code(glm::dvec3 p, const Box& bounds) {
  std::uint64_t code = 0;
  for (int k = 0; k < 3; ++k) {
    const double size = static_cast<double>(bounds.hi[k]) - static_cast<double>(bounds.lo[k]);
    const double at = size > 0.0 ? (p[k] - static_cast<double>(bounds.lo[k])) / size : 0.0;
    constexpr double cells = 1 << bits_an_axis;
    code |= spread(static_cast<std::uint64_t>(std::clamp(at * cells, 0.0, cells - 1.0))) << k;
  }
  return code;
}

Box box_of(const World& world, std::uint32_t triangle) {
  Box box;
  for (int k = 0; k < 3; ++k) box.grow(world.positions[world.triangles[triangle][k]]);
  return box;
}

std::vector<std::uint32_t> along_morton_curve(const World& world,
                                              std::vector<std::uint32_t> triangles,
                                              const std::stop_token& stop) {
  std::vector<Keyed> keyed(triangles.size());
  in_parallel(triangles.size(), stop, [&](std::uint32_t i) {
    const Box box = box_of(world, triangles[i]);
    const glm::dvec3 middle = 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi));
    keyed[i] = {morton_code(middle, world.bounds), triangles[i]};
  });
  sort_in_tasks(keyed.begin(), keyed.end(), [](const Keyed& x, const Keyed& y) {
    return x.code != y.code ? x.code < y.code : x.triangle < y.triangle;
  });
  std::transform(keyed.begin(), keyed.end(), triangles.begin(),
                 [](const Keyed& k) { return k.triangle; });
  return triangles;
}

std::vector<std::uint32_t> first_numbers(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

constexpr std::size_t nodes_for(std::size_t children) {
  return (children + BoxTree::width - 1) / BoxTree::width;
}

}  // namespace

BoxTree::BoxTree(const World& world, std::size_t triangles, const std::stop_token& stop)
    : BoxTree(world, first_numbers(triangles), stop) {}

BoxTree::BoxTree(const World& world, std::vector<std::uint32_t> triangles,
                 const std::stop_token& stop)
    : triangles_(along_morton_curve(world, std::move(triangles), stop)) {
  if (triangles_.empty()) return;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr OneBox nothing{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  // Add levels up to the root, where each node is the union of its children.
  const auto add_level = [&](std::size_t children, const auto& box_of_child) {
    std::vector<Boxes> level(nodes_for(children));
    in_parallel(level.size(), stop, [&](std::uint32_t node) {
      for (std::size_t i = 0; i < width; ++i) {
        const std::size_t child = std::size_t{node} * width + i;
        put(level[node], i, child < children ? box_of_child(child) : nothing);
      }
    });
    levels_.push_back(std::move(level));
  };
  add_level(triangles_.size(), [&](std::size_t i) {
    const Box box = box_of(world, triangles_[i]);
    return OneBox{{box.lo.x, box.lo.y, box.lo.z}, {box.hi.x, box.hi.y, box.hi.z}};
  });
  do {
    const std::vector<Boxes>& below = levels_.back();
    add_level(below.size(), [&](std::size_t i) { return union_of(below[i]); });
  } while (levels_.back().size() > 1);
}

BoxTree::OneBox BoxTree::union_of(const Boxes& boxes) {
  OneBox box = at(boxes, 0);
  for (std::size_t i = 1; i < width; ++i) {
    for (int k = 0; k < 3; ++k) {
      box.lo[k] = std::min(box.lo[k], boxes.lo[k][i]);
      box.hi[k] = std::max(box.hi[k], boxes.hi[k][i]);
    }
  }
  return box;
}

void BoxTree::put(Boxes& boxes, std::size_t i, const OneBox& box) {
  for (int k = 0; k < 3; ++k) boxes.lo[k][i] = box.lo[k], boxes.hi[k][i] = box.hi[k];
}

BoxTree::Lanes BoxTree::overlapping(const Boxes& boxes, const OneBox& box) {
  // Four at a time, in the vectors that GCC and Clang offer on all processors.
  constexpr std::size_t few = 4;
  using Floats = float __attribute__((vector_size(sizeof(float) * few)));
  using Masks = std::int32_t __attribute__((vector_size(sizeof(float) * few)));
  Lanes lanes = 0;
  for (std::size_t at = 0; at < width; at += few) {
    Masks all = Masks{} == Masks{};
    for (int k = 0; k < 3; ++k) {
      Floats lo, hi;
      std::memcpy(&lo, boxes.lo[k] + at, sizeof lo);
      std::memcpy(&hi, boxes.hi[k] + at, sizeof hi);
      all &= (lo <= box.hi[k]) & (hi >= box.lo[k]);
    }
#if defined(__SSE__)
    lanes |= static_cast<Lanes>(__builtin_ia32_movmskps(std::bit_cast<Floats>(all))) << at;
#else
    for (std::size_t i = 0; i < few; ++i) lanes |= (all[i] ? Lanes{1} : Lanes{0}) << (at + i);
#endif
  }
  return lanes;
}

}  // namespace asos
