#include "renderer/shading/sky_lobes.h"

#include "renderer/lights/light_math.h"
#include "renderer/shading/dfr.h"
#include "renderer/shading/sky_map.h"
#include "renderer/tasks.h"

#include <numbers>
#include <tbb/task_arena.h>

namespace asos {
namespace {

/// A node's part of the sphere is about (node_spacing / cells) radians wide.
constexpr double node_spacing = 3.545;  // root of 4 pi
/// The finest source, and each has 1 / sqrt(2) times the cells of the finer one.
constexpr std::int32_t source_cells = 128;
constexpr int sources = 9;
/// A lobe is summed over so many by so many squares.
constexpr int squares = 8;
/// Nodes of a lobe's map across the lobe, and its least number of cells: the widest lobes have
/// sharp borders, too.
constexpr double cells_of_unit_lobe = 32.0;
constexpr std::int32_t least_cells = 48;
/// Irradiance varies slowly, and is the sum of texels of some 3 degrees.
constexpr std::int32_t irradiance_cells = 48;
constexpr int irradiance_rows = 64;

/// Returns the unit direction of a place.
glm::vec3 direction_at(float u, float v) {
  glm::vec3 d(u, 1.0f - std::abs(u) - std::abs(v), v);
  if (d.y < 0.0f) {
    d.x = std::copysign(1.0f - std::abs(v), u);
    d.z = std::copysign(1.0f - std::abs(u), v);
  }
  return glm::normalize(d);
}

/// Makes a map of value(direction), on all processors.
template <typename Value>
OctahedralMap octahedral_map(std::int32_t cells, const Value& value) {
  OctahedralMap map;
  map.cells = cells;
  const auto stride = static_cast<std::size_t>(map.stride());
  map.nodes.resize(stride * stride);
  const auto coordinate = [cells](std::size_t i) {
    return static_cast<float>(2 * static_cast<std::int32_t>(i) - cells) / static_cast<float>(cells);
  };
  const auto fill_row = [&](std::size_t row) {
    glm::vec4* nodes = &map.nodes[row * stride];
    for (std::size_t column = 0; column + 1 < stride; ++column)
      nodes[column] = glm::vec4(value(direction_at(coordinate(column), coordinate(row))), 0.0f);
    nodes[stride - 1] = nodes[stride - 2];
  };
  // A thread that waits here must not begin another task: that may wait for this map.
  tbb::this_task_arena::isolate([&] {
    in_task_ranges(stride - 1, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row) fill_row(row);
    });
  });
  std::copy_n(map.nodes.end() - 2 * map.stride(), stride, map.nodes.end() - map.stride());
  return map;
}

std::int32_t even_number(double cells) {
  return 2 * static_cast<std::int32_t>(std::ceil(0.5 * cells));
}

/// A texel's radiance, its solid angle, and the mean of its directions, which is no unit vector.
/// With this mean, the cosine to a normal is exact for a texel above the horizon.
struct SkyPatch {
  glm::dvec3 radiance;
  glm::dvec3 direction;
  double solid_angle;
};

/// A row of texels.
class PatchRow {
 public:
  PatchRow(const SkyRows& picture, int row)
      : picture_(&picture), row_(row), columns_(picture.columns(row)) {
    const double t0 = pi_ * row / picture.rows(), t1 = pi_ * (row + 1) / picture.rows();
    const double height = std::cos(t0) - std::cos(t1);
    const double s0 = std::sin(t0), s1 = std::sin(t1);
    const double mean_sine =
        (0.5 * (t1 - t0) - 0.25 * (std::sin(2.0 * t1) - std::sin(2.0 * t0))) / height;
    up_ = 0.5 * (s1 * s1 - s0 * s0) / height;
    const double half = pi_ / columns_;
    across_ = columns_ > 1 ? mean_sine * std::sin(half) / half : 0.0;
    solid_angle_ = 2.0 * pi_ * height / columns_;
  }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] SkyPatch at(int column) const {
    const double angle = 2.0 * pi_ * ((column + 0.5) / columns_ - 0.5);
    return {picture_->texel(row_, column),
            {across_ * std::sin(angle), up_, -across_ * std::cos(angle)},
            solid_angle_};
  }

 private:
  static constexpr double pi_ = std::numbers::pi;
  const SkyRows* picture_;
  int row_;
  int columns_;
  double up_, across_, solid_angle_;
};

/// Texels near each other. Above a surface's horizon their sum is a linear function of its normal.
class PatchBlock {
 public:
  explicit PatchBlock(const std::vector<SkyPatch>& patches) {
    glm::dvec3 sum(0.0);
    for (const SkyPatch& patch : patches) sum += patch.direction;
    const double length = glm::length(sum);
    const glm::dvec3 middle = length > 0.0 ? sum / length : glm::dvec3(0.0);
    double cosine = 1.0;
    std::array<glm::dvec4, 3> whole{};
    for (const SkyPatch& patch : patches) {
      const double size = glm::length(patch.direction);
      cosine = std::min(cosine, size > 0.0 ? glm::dot(patch.direction, middle) / size : -1.0);
      const glm::dvec3 weighted = patch.solid_angle * patch.direction;
      const glm::dvec4 power(patch.radiance, 1.0);
      for (int axis = 0; axis < 3; ++axis) whole[axis] += weighted[axis] * power;
      parts_.push_back({glm::vec3(patch.direction), glm::vec4(patch.solid_angle * power)});
    }
    std::copy(whole.begin(), whole.end(), whole_.begin());
    middle_ = glm::vec3(middle);
    constexpr float never = 2.0f;
    reach_ = cosine > 0.0 ? static_cast<float>(std::sqrt(1.0 - cosine * cosine)) : never;
  }

  /// Adds irradiance, and the solid angle times cosine.
  void add(glm::vec3 normal, glm::dvec4& sum) const {
    const float height = glm::dot(normal, middle_);
    if (height < -reach_) return;
    if (height > reach_) {
      sum += glm::dvec4(normal.x * whole_[0] + normal.y * whole_[1] + normal.z * whole_[2]);
      return;
    }
    for (const Part& part : parts_)
      sum += glm::dvec4(std::max(0.0f, glm::dot(normal, part.direction)) * part.power);
  }

 private:
  struct Part {
    glm::vec3 direction;
    glm::vec4 power;  ///< radiance times solid angle, and solid angle
  };

  glm::vec3 middle_{0.0f};
  float reach_ = 0.0f;                ///< sine of the radius; beyond 1: it is not small
  std::array<glm::vec4, 3> whole_{};  ///< per component of the normal
  std::vector<Part> parts_;
};

/// Divides a picture into blocks of about 4 x 4 texels.
std::vector<PatchBlock> blocks_of(const SkyRows& picture) {
  constexpr int side = 4;
  std::vector<PatchBlock> blocks;
  for (int first = 0; first < picture.rows(); first += side) {
    const int end = std::min(picture.rows(), first + side);
    const int sectors = std::max(1, picture.columns((first + end) / 2) / side);
    std::vector<std::vector<SkyPatch>> patches(static_cast<std::size_t>(sectors));
    for (int r = first; r < end; ++r) {
      const PatchRow row(picture, r);
      for (int i = 0; i < row.columns(); ++i)
        patches[static_cast<std::size_t>(i * sectors / row.columns())].push_back(row.at(i));
    }
    for (const std::vector<SkyPatch>& block : patches)
      if (!block.empty()) blocks.emplace_back(block);
  }
  return blocks;
}

/// The weights add up to pi, except for texels at the horizon. Dividing by their sum keeps constant
/// skies exact. A sky of a single texel has nothing above the horizon.
glm::vec3 irradiance_over_pi_of(const std::vector<PatchBlock>& blocks, glm::vec3 normal,
                                glm::vec3 otherwise) {
  glm::dvec4 sum(0.0);
  for (const PatchBlock& block : blocks) block.add(normal, sum);
  return sum.w > 0.0 ? glm::vec3(glm::dvec3(sum) / sum.w) : otherwise;
}

}  // namespace

SkyLobes::SkyLobes(const SkyMap& picture) {
  const SkyRows& coarse = picture.rows_below(irradiance_rows);
  irradiance_ = octahedral_map(irradiance_cells, [&, blocks = blocks_of(coarse)](glm::vec3 d) {
    return irradiance_over_pi_of(blocks, d, coarse.texel(0, 0));
  });
  // A bilinear look-up widens a node's own mean, so that is narrower than its part of the sphere.
  constexpr double own_width = 0.6;
  for (int i = 0; i < sources; ++i) {
    const std::int32_t cells = even_number(source_cells / std::pow(2.0, 0.5 * i));
    const double side = own_width * node_spacing / cells;
    sources_.push_back(octahedral_map(cells, [&](glm::vec3 d) { return picture.mean(d, side); }));
  }
}

const OctahedralMap& SkyLobes::make(std::size_t i) const {
  const std::scoped_lock lock(making_);
  if (lobes_[i]) return *lobes_[i];
  const double width = lobe_width(static_cast<double>(i + first_step) / steps);
  // The squares in the plane one unit ahead, each with a source of its width.
  struct Square {
    glm::vec2 at;
    const OctahedralMap* source;
  };
  std::array<Square, squares * squares> parts;
  for (int k = 0; k < squares * squares; ++k) {
    const glm::dvec2 place((k % squares + 0.5) / squares - 0.5,
                           (k / squares + 0.5) / squares - 0.5);
    const glm::dvec2 at = width * place;
    const double cosine = 1.0 / std::sqrt(1.0 + glm::dot(at, at));
    const double side = width / squares * cosine * std::sqrt(cosine);
    // Somewhat narrower: the sources' bilinear look-ups overlap.
    const double coarser = 2.0 * std::log2(0.7 * side * source_cells / node_spacing);
    const auto source =
        static_cast<std::size_t>(std::clamp(std::lround(coarser), 0L, sources - 1L));
    parts[static_cast<std::size_t>(k)] = {at, &sources_[source]};
  }
  const std::int32_t cells = std::max(least_cells, even_number(cells_of_unit_lobe / width));
  lobes_[i] = std::make_unique<const OctahedralMap>(octahedral_map(cells, [&parts](glm::vec3 d) {
    const glm::vec3 right(any_perpendicular(glm::dvec3(d))), down = glm::cross(d, right);
    glm::vec4 sum(0.0f);
    for (const Square& part : parts)
      sum += part.source->at(OctahedralMap::place(d + part.at.x * right + part.at.y * down));
    return glm::vec3(sum) / static_cast<float>(parts.size());
  }));
  made_[i].store(lobes_[i].get(), std::memory_order_release);
  return *lobes_[i];
}

glm::vec3 SkyLobes::around(glm::vec3 direction, float roughness) const {
  const float at =
      std::clamp(roughness * static_cast<float>(steps) - static_cast<float>(first_step), 0.0f,
                 static_cast<float>(maps - 1));
  const float finer = at >= 0.0f ? std::min(std::floor(at), static_cast<float>(maps - 2)) : 0.0f;
  const glm::vec2 place = OctahedralMap::place(direction);
  const auto i = static_cast<std::size_t>(finer);
  const glm::vec4 a = lobe(i).at(place), b = lobe(i + 1).at(place);
  return glm::vec3(a + (at - finer) * (b - a));
}

std::size_t SkyLobes::memory_bytes() const {
  const std::scoped_lock lock(making_);
  std::size_t bytes = irradiance_.nodes.size() * sizeof(glm::vec4);
  for (const OctahedralMap& source : sources_) bytes += source.nodes.size() * sizeof(glm::vec4);
  for (const auto& map : lobes_)
    if (map) bytes += map->nodes.size() * sizeof(glm::vec4);
  return bytes;
}

}  // namespace asos
