#include "renderer/scene/builtin/cut_outs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace asos::builtin {

namespace {

constexpr int side_texels = 128;
// Width of the fall of alpha from 1 to 0 around an outline, in texels.
constexpr double softness = 6.0;

struct Look {
  double outside = 0.0;  ///< distance from the shapes, in sides of the image; negative within
  glm::dvec3 srgb{1.0};
};

template <typename LookAt>
Image painted_shapes(const std::string& name, LookAt look_at) {
  Image image{name, side_texels, side_texels, {}};
  const auto add = [&](double value) {
    image.rgba.own().push_back(
        static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0))));
  };
  for (int y = 0; y < side_texels; ++y) {
    for (int x = 0; x < side_texels; ++x) {
      const Look look = look_at(glm::dvec2(x + 0.5, y + 0.5) / static_cast<double>(side_texels));
      for (int k = 0; k < 3; ++k) add(look.srgb[k]);
      add(0.5 - look.outside * side_texels / softness);
    }
  }
  return image;
}

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 d = b - a;
  return glm::distance(p, a + std::clamp(glm::dot(p - a, d) / glm::dot(d, d), 0.0, 1.0) * d);
}

// The intersection of two disks: two arcs from stalk to tip.
double leaf(glm::dvec2 p, glm::dvec2 stalk, glm::dvec2 tip, double width) {
  const glm::dvec2 middle = 0.5 * (stalk + tip), way = tip - stalk;
  const double half = 0.5 * glm::length(way);
  const glm::dvec2 across = glm::dvec2(-way.y, way.x) / (2.0 * half);
  const double radius = (half * half + 0.25 * width * width) / width;
  const glm::dvec2 offset = (radius - 0.5 * width) * across;
  return std::max(glm::distance(p, middle + offset), glm::distance(p, middle - offset)) - radius;
}

}  // namespace

Image wrought_iron() {
  return painted_shapes("wrought iron", [](glm::dvec2 p) {
    // Bars pass through the image's corners, so that the image can be repeated.
    const glm::dvec2 from_bar = glm::abs(p - glm::round(p));
    const glm::dvec2 q = glm::abs(p - 0.5);
    const double bars = std::min(from_bar.x, from_bar.y) - 0.035;
    const double ring = std::abs(glm::length(q) - 0.36) - 0.03;
    const double lozenge = std::abs(q.x + q.y - 0.26) / std::sqrt(2.0) - 0.022;
    return Look{std::min({bars, ring, lozenge}), {0.16, 0.17, 0.18}};
  });
}

Image twig() {
  return painted_shapes("twig", [](glm::dvec2 p) {
    Look look;
    look.outside = distance_to_segment(p, {0.5, 1.0}, {0.5, 0.3}) - 0.014;
    look.srgb = {0.36, 0.27, 0.16};
    const auto add = [&](glm::dvec2 stalk, glm::dvec2 tip, glm::dvec3 srgb) {
      const double outside = leaf(p, stalk, tip, 0.15);
      if (outside < look.outside) look = {outside, srgb};
    };
    add({0.5, 0.34}, {0.5, 0.03}, {0.42, 0.62, 0.25});
    for (int i = 0; i < 3; ++i) {
      const double y = 0.44 + 0.19 * i, reach = 0.3 + 0.05 * i;
      add({0.5, y}, {0.5 - reach, y - 0.22}, {0.31, 0.52 - 0.05 * i, 0.19});
      add({0.5, y + 0.06}, {0.5 + reach, y - 0.15}, {0.36, 0.58 - 0.05 * i, 0.2});
    }
    return look;
  });
}

int paint_cut_out(SceneAssembler& stage, const std::string& name, Image image, Wrap wrap) {
  const int texture = stage.keep_texture(std::move(image), wrap);
  const int index = stage.paint(name, 0xffffff, 0.85f);
  stage.make_double_sided(index);
  Material& material = stage.material(name);
  material.base_color_texture.texture = texture;
  material.alpha_mode = AlphaMode::mask;
  return index;
}

void add_card(Mesh& mesh, glm::vec3 corner, glm::vec3 right, glm::vec3 down, glm::vec2 uv_lo,
              glm::vec2 uv_hi) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const glm::vec3 normal = glm::normalize(glm::cross(down, right));
  for (const glm::vec2 at : {glm::vec2(0, 1), {1, 1}, {1, 0}, {0, 0}}) {
    mesh.positions.push_back(corner + at.x * right + at.y * down);
    mesh.normals.push_back(normal);
    mesh.texcoords[0].push_back(glm::mix(uv_lo, uv_hi, at));
  }
  mesh.triangles.emplace_back(first, first + 1, first + 2);
  mesh.triangles.emplace_back(first, first + 2, first + 3);
}

}  // namespace asos::builtin
