#include "renderer/features/cut_outs.h"

#include "renderer/features/alpha_contour.h"
#include "renderer/features/contour_placer.h"
#include "renderer/features/stoppable_loop.h"
#include "renderer/world/surface_kind.h"
#include "renderer/world/texture_image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace asos {
namespace {

/// Largest distance of a piece from its curve, in texels, for a part with at most 1/`share` of all
/// lines. The first is a thousandth of a pixel if a texel is eight pixels wide. Parts with many
/// lines have many texels and are rarely seen from so near; if a texel is one pixel wide, the
/// second is 1/256 of a pixel.
struct Fineness {
  double tolerance;
  std::size_t share;
};
constexpr std::array finenesses{Fineness{1.0 / 8192.0, 64}, Fineness{1.0 / 256.0, 8},
                                Fineness{1.0 / 128.0, 1}};
// Largest number of different vertex alphas per material that get a contour of their own. With
// more, nearly every triangle would need one.
constexpr std::size_t most_factors = 16;
constexpr std::size_t looks_between_checks = 1024;
// A part is given up early if a survey of this many triangles, spread over it, finds `survey_slack`
// times more lines than these may have.
constexpr std::uint32_t surveyed = 64;
constexpr std::size_t survey_slack = 2;

bool is_masked(const Material& m) {
  return surface_kind(m) == SurfaceKind::masked;
}

/// Gives equal places the same number.
class PlaceNumbers {
 public:
  explicit PlaceNumbers(std::vector<glm::vec3>& positions) : positions_(positions) {}

  std::uint32_t number(glm::vec3 p) {
    const auto [found, added] =
        known_.try_emplace(p, static_cast<std::uint32_t>(positions_.size()));
    if (added) positions_.push_back(p);
    return found->second;
  }
  void forget() { known_.clear(); }

 private:
  struct Hash {
    std::size_t operator()(const glm::vec3& p) const {
      std::uint64_t hash = 0;
      for (int k = 0; k < 3; ++k) {
        hash = (hash ^ std::bit_cast<std::uint32_t>(p[k] + 0.0f)) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 29;
      }
      return static_cast<std::size_t>(hash);
    }
  };
  std::vector<glm::vec3>& positions_;
  std::unordered_map<glm::vec3, std::uint32_t, Hash> known_;
};

class CutOutFinder {
 public:
  CutOutFinder(const World& world, const CutOutBudget& budget, const std::stop_token& stop)
      : world_(world), budget_(budget), stop_(stop), numbers_(found_.positions) {}

  CutOuts run() {
    const bool any = std::any_of(world_.parts.begin(), world_.parts.end(), [&](const Part& part) {
      return is_masked(world_.materials[part.material]);
    });
    if (!any) return {};
    found_.outlined.assign(world_.surface_count(), 0);
    found_.hidden_sides.assign(world_.surface_count(), 0);
    for (const Part& part : world_.parts)
      if (is_masked(world_.materials[part.material])) outline(part);
    // A shape without a texture is completely visible or completely cut out.
    for (std::uint32_t s = 0; s < world_.surface_count(); ++s) {
      const Material& m = world_.material_of(s);
      if (world_.is_face(s)) found_.outlined[s] = is_masked(m) && !m.base_color_texture.used();
    }
    return std::move(found_);
  }

 private:
  // Outlines a part as finely as the budget allows, or not at all.
  void outline(const Part& part) {
    const std::size_t before = found_.lines.size(), positions_before = found_.positions.size();
    for (const Fineness& fineness : finenesses) {
      const std::size_t left = budget_.lines - before;
      most_lines_ = before + std::min(left, budget_.lines / fineness.share);
      if (outline(part, fineness.tolerance)) return;
      found_.lines.resize(before);
      found_.positions.resize(positions_before);
    }
    for (auto* const flags : {&found_.outlined, &found_.hidden_sides})
      std::fill_n(flags->begin() + part.first_triangle, part.triangle_count, std::uint8_t{0});
  }

  bool outline(const Part& part, double tolerance) {
    numbers_.forget();
    // Limit each part, so that one cannot use up the looks of the others.
    const std::size_t others = budget_.looks - budget_.looks / 4;
    looks_ = budget_.looks / 4;
    const bool outlined = outline_triangles(part, tolerance);
    budget_.looks = others + looks_;
    return outlined;
  }

  // Returns whether a few of the part's triangles show that all of them have too many lines. The
  // survey has a margin, so that it does not refuse parts that fit.
  bool hopeless(const Part& part, double tolerance) {
    if (part.triangle_count < 8 * surveyed) return false;
    const std::size_t looks = looks_;
    const std::size_t enough = survey_slack * (most_lines_ - found_.lines.size()) * surveyed /
                               std::size_t{part.triangle_count};
    std::size_t lines = 0;
    bool told = true;
    for (std::uint32_t i = 0; i < surveyed && told && lines <= enough; ++i) {
      lines_.clear();
      const auto at = static_cast<std::uint32_t>(std::uint64_t{part.triangle_count} * i / surveyed);
      told = outline(part.first_triangle + at, tolerance).has_value();
      lines += lines_.size();
    }
    looks_ = looks;
    return told && lines > enough;
  }

  bool outline_triangles(const Part& part, double tolerance) {
    if (hopeless(part, tolerance)) return false;
    for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
      if (i % looks_between_checks == 0) check_stop(stop_);
      const std::uint32_t triangle = part.first_triangle + i;
      lines_.clear();
      const std::optional<bool> outlined = outline(triangle, tolerance);
      if (!outlined) return false;
      found_.outlined[triangle] = *outlined;
      for (const ContourPlacer::Line& line : lines_)
        found_.lines.push_back({numbers_.number(line.from), numbers_.number(line.to), triangle});
    }
    return true;
  }

  // Adds the triangle's lines. Returns whether they outline all of its cut-outs; nothing if the
  // budget does not suffice.
  std::optional<bool> outline(std::uint32_t triangle, double tolerance) {
    const Material& material = world_.material_of(triangle);
    const glm::uvec3 corners = world_.triangles[triangle];
    float factor = material.base_color.a;
    if (!world_.colors.empty()) {
      const float alpha = world_.colors[corners.x].a;
      if (world_.colors[corners.y].a != alpha || world_.colors[corners.z].a != alpha) return false;
      factor *= alpha;
    }
    const TextureUse& use = material.base_color_texture;
    const Image* const image = image_of(world_, use.texture);
    const auto& coordinates = world_.texcoords[use.texcoord];
    if (!image || coordinates.empty()) return true;
    const AlphaContour* const contour =
        contour_of(*image, use.texture, factor, material.alpha_cutoff);
    if (!contour) return false;
    TexturedTriangle shown;
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(k);
      shown.positions[at] = glm::dvec3(world_.positions[corners[k]]);
      // Use the same numbers as rays, so that equal points of the texture's plane stay equal.
      const glm::dvec3 uv(glm::dvec2(coordinates[corners[k]]), 1.0);
      shown.texels[at] = texel_place(*image, glm::dvec2(glm::dmat3(use.uv_transform) * uv));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (placer_.hides(shown.texels[k], shown.texels[(k + 1) % 3], *contour, looks_))
        found_.hidden_sides[triangle] |= static_cast<std::uint8_t>(1u << k);
    }
    if (contour->empty()) return true;
    // Rays miss triangles without area.
    const glm::dvec3 area = glm::cross(shown.positions[1] - shown.positions[0],
                                       shown.positions[2] - shown.positions[0]);
    if (area == glm::dvec3(0.0)) return true;
    if (shown.flat_in_texture()) return !placer_.comes_near(shown, *contour, looks_);
    const std::size_t left = most_lines_ - found_.lines.size();
    if (!placer_.place(shown, *contour, tolerance, left, looks_, lines_)) return std::nullopt;
    return true;
  }

  // Returns null if the contour is endless, or if there are too many contours.
  const AlphaContour* contour_of(const Image& image, int texture_index, float factor,
                                 float cutoff) {
    const Texture& texture = world_.textures[static_cast<std::size_t>(texture_index)];
    const Key key{&image, texture.wrap_u, texture.wrap_v, texture.filter, factor, cutoff};
    auto known = contours_.find(key);
    if (known == contours_.end()) {
      check_stop(stop_);
      if (++factors_of_[{&texture, cutoff}] > most_factors) return nullptr;
      known = contours_.try_emplace(key, image, texture, factor, cutoff).first;
    }
    return known->second.endless() ? nullptr : &known->second;
  }

  using Key = std::tuple<const Image*, Wrap, Wrap, Filter, float, float>;

  const World& world_;
  CutOutBudget budget_;         // with the remaining looks
  std::size_t most_lines_ = 0;  // up to the current part's end
  std::size_t looks_ = 0;       // the looks that a part may use
  std::stop_token stop_;
  CutOuts found_;
  PlaceNumbers numbers_;
  ContourPlacer placer_;
  std::vector<ContourPlacer::Line> lines_;
  std::map<Key, AlphaContour> contours_;
  std::map<std::pair<const Texture*, float>, std::size_t> factors_of_;
};

}  // namespace

CutOuts find_cut_outs(const World& world, const CutOutBudget& budget, const std::stop_token& stop) {
  return CutOutFinder(world, budget, stop).run();
}

}  // namespace asos
