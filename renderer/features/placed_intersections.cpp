#include "renderer/features/placed_intersections.h"

#include "renderer/features/stoppable_loop.h"
#include "renderer/tasks.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>

namespace asos {
namespace {

// Number of box pairs per part after which the search is given up.
constexpr std::size_t most_box_pairs = 1024;
// Further boxes around a part are merged into its last one.
constexpr std::size_t most_boxes_around = 32;

bool boxes_meet(const Box& a, const Box& b) {
  return glm::all(glm::lessThanEqual(a.lo, b.hi)) && glm::all(glm::lessThanEqual(b.lo, a.hi));
}

Box common_box(const Box& a, const Box& b) {
  Box box;
  box.lo = glm::max(a.lo, b.lo), box.hi = glm::min(a.hi, b.hi);
  return box;
}

/// For each part, the common boxes with other parts, where one of the two is a placed mesh. `find`
/// returns false if too many pairs of boxes have to be compared.
class CommonBoxes {
 public:
  explicit CommonBoxes(const World& world) : world_(world), common_(world.parts.size()) {}

  [[nodiscard]] bool find() {
    std::vector<std::uint32_t> order(world_.parts.size());
    std::iota(order.begin(), order.end(), 0u);
    std::erase_if(order, [&](std::uint32_t i) { return world_.parts[i].bounds.empty(); });
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return box(a).lo.x != box(b).lo.x ? box(a).lo.x < box(b).lo.x : a < b;
    });
    std::size_t pairs = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      for (std::size_t m = k + 1; m < order.size(); ++m) {
        if (box(order[m]).lo.x > box(order[k]).hi.x) break;
        if (++pairs > most_box_pairs * order.size()) return false;
        compare(order[k], order[m]);
      }
    }
    return true;
  }
  [[nodiscard]] const std::vector<Box>& of(std::size_t part) const { return common_[part]; }

 private:
  [[nodiscard]] const Box& box(std::uint32_t part) const { return world_.parts[part].bounds; }
  [[nodiscard]] bool placed(std::uint32_t part) const {
    return world_.is_placed(world_.parts[part].first_triangle);
  }
  void compare(std::uint32_t a, std::uint32_t b) {
    if (!(placed(a) || placed(b)) || !boxes_meet(box(a), box(b))) return;
    const Box common = common_box(box(a), box(b));
    add(a, common);
    add(b, common);
  }
  void add(std::uint32_t part, const Box& common) {
    std::vector<Box>& boxes = common_[part];
    if (boxes.size() < most_boxes_around)
      boxes.push_back(common);
    else
      boxes.back().grow(common);
  }

  const World& world_;
  std::vector<std::vector<Box>> common_;
};

/// Returns the positions of a part, as in World::positions.
std::vector<glm::vec3> positions_of(const World& world, const Part& part) {
  std::vector<glm::vec3> positions(part.vertex_count);
  if (!world.is_placed(part.first_triangle)) {
    for (std::uint32_t i = 0; i < part.vertex_count; ++i)
      positions[i] = world.positions[part.first_vertex + i];
    return positions;
  }
  const Placement& place = world.placements->of_triangle(part.first_triangle);
  const std::vector<glm::vec3>& of_mesh = world.placements->mesh_of(place).positions.own();
  std::transform(of_mesh.begin(), of_mesh.end(), positions.begin(),
                 [&](glm::vec3 p) { return placed_point(*world.placements, place, p); });
  return positions;
}

void add_triangles(const World& world, const Part& part, const std::vector<Box>& boxes,
                   std::vector<std::uint32_t>& found) {
  const std::vector<glm::vec3> positions = positions_of(world, part);
  for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    const glm::uvec3 corners = world.triangles[t];
    Box box;
    for (int k = 0; k < 3; ++k) box.grow(positions[corners[k] - part.first_vertex]);
    if (std::any_of(boxes.begin(), boxes.end(),
                    [&](const Box& common) { return boxes_meet(box, common); }))
      found.push_back(t);
  }
}

}  // namespace

Intersections find_placed_intersections(const World& world, const IntersectionBudget& budget,
                                        const std::stop_token& stop) {
  if (!world.placements) return {};
  CommonBoxes common(world);
  if (!common.find()) return {{}, false};
  // Process some parts at a time, in parallel, so that the search ends soon if it is given up.
  constexpr std::size_t parts_at_once = 1024;
  std::vector<std::uint32_t> candidates;
  for (std::size_t first = 0; first < world.parts.size(); first += parts_at_once) {
    check_stop(stop);
    const std::size_t count = std::min(parts_at_once, world.parts.size() - first);
    std::vector<std::vector<std::uint32_t>> found(count);
    in_tasks(count, [&](std::size_t i) {
      const std::vector<Box>& boxes = common.of(first + i);
      if (!boxes.empty()) add_triangles(world, world.parts[first + i], boxes, found[i]);
    });
    for (const std::vector<std::uint32_t>& more : found)
      candidates.insert(candidates.end(), more.begin(), more.end());
    if (candidates.size() > most_candidates) return {{}, false};
  }
  std::sort(candidates.begin(), candidates.end());
  return intersections_among(world, std::move(candidates), budget, stop);
}

}  // namespace asos
