#include "renderer/samples/surface_view.h"

#include "renderer/shading/surface.h"
#include "renderer/shading/texture.h"
#include "renderer/world/ground.h"

#include <algorithm>
#include <cmath>

namespace asos {

namespace {

constexpr float line_half_width = 0.5f;  // of the wireframe, in pixels
constexpr float checks_per_tile = 8.0f;

// Returns the radiance that the sRGB curve displays as `value`.
glm::vec3 shown_as(glm::vec3 value) {
  const auto decode = [](float v) {
    const float x = std::clamp(v, 0.0f, 1.0f);
    return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
  };
  return {decode(value.x), decode(value.y), decode(value.z)};
}

bool is_colour(SurfaceProperty property) {
  return property == SurfaceProperty::base_color || property == SurfaceProperty::emission ||
         property == SurfaceProperty::vertex_color;
}

// Returns a checkerboard whose hue changes with each repeat of the texture, so that repeats are
// visible.
glm::vec3 checker(glm::vec2 uv) {
  if (!std::isfinite(uv.x + uv.y)) return glm::vec3(0.0f);
  const glm::vec2 tile = glm::floor(uv), check = glm::floor(checks_per_tile * uv);
  const bool dark = std::fmod(std::abs(check.x + check.y), 2.0f) > 0.5f;
  const float hue = tile.x * 0.31f + tile.y * 0.47f;
  const auto channel = [&](float shift) {
    return 0.75f + 0.2f * std::cos(6.2831853f * (hue + shift));
  };
  return (dark ? 0.45f : 1.0f) * glm::vec3(channel(0.0f), channel(0.33f), channel(0.67f));
}

// Returns the smallest distance of a hit from its triangle's edges, in pixels along their normals.
float edge_distance(const World& world, const Hit& hit, const PixelSpacing& spacing,
                    glm::vec3 direction, glm::vec3 normal) {
  if (world.is_face(hit.triangle)) return 1e9f;
  const Footprint pixel =
      footprint_on(world, hit, patch_on_plane(spacing, direction, hit.t, normal, 1.0f));
  if (pixel.point()) return 1e9f;
  const glm::vec3 weights(1.0f - hit.b1 - hit.b2, hit.b1, hit.b2);
  const glm::vec3 right(-pixel.right.x - pixel.right.y, pixel.right.x, pixel.right.y);
  const glm::vec3 down(-pixel.down.x - pixel.down.y, pixel.down.x, pixel.down.y);
  float nearest = 1e9f;
  for (int i = 0; i < 3; ++i) {
    const float slope = std::hypot(right[i], down[i]);
    if (slope > 0.0f) nearest = std::min(nearest, weights[i] / slope);
  }
  return nearest;
}

class Looker {
 public:
  Looker(const RenderScene& scene, const View& view, SurfaceProperty property, float side)
      : scene_(scene),
        property_(property),
        spacing_(PixelSpacing::of(view)),
        extent_{&spacing_, &scene.mips(), side, {}, 1.0f} {}

  struct Seen {
    glm::vec3 value{0.0f};
    float line = 0.0f;
  };
  [[nodiscard]] Seen look(const Ray& ray, const Hit& hit) const {
    const World& world = scene_.world();
    const glm::vec3 direction(ray.direction);
    const SurfacePoint point =
        surface_point(world, scene_.render_features, hit, -direction, extent_);
    Seen seen;
    seen.value = property(hit, point);
    if (!std::isfinite(seen.value.x + seen.value.y + seen.value.z)) seen.value = glm::vec3(0.0f);
    if (edge_distance(world, hit, spacing_, direction, point.geometric_normal) < line_half_width)
      seen.line = 1.0f;
    return seen;
  }

 private:
  [[nodiscard]] glm::vec3 property(const Hit& hit, const SurfacePoint& point) const {
    const World& world = scene_.world();
    if (property_ == SurfaceProperty::normal) return 0.5f * point.shading_normal + 0.5f;
    if (property_ == SurfaceProperty::texture_coordinates) return checker(uv_of(hit));
    if (property_ == SurfaceProperty::second_texture_coordinates)
      return world.texcoords[1].empty()
                 ? glm::vec3(0.0f)
                 : checker(texcoord_at(world, 1, hit.triangle, hit.b1, hit.b2));
    if (property_ == SurfaceProperty::vertex_color)
      return world.colors.empty() || world.is_face(hit.triangle)
                 ? glm::vec3(1.0f)
                 : glm::vec3(vertex_color(world, hit.triangle, hit.b1, hit.b2));
    const SurfaceMaterial material =
        surface_material(world, scene_.render_features, hit, point.footprint, &scene_.mips());
    switch (property_) {
      case SurfaceProperty::base_color:
        return material.base_color;
      case SurfaceProperty::emission:
        return material.emission;
      case SurfaceProperty::roughness:
        return glm::vec3(material.roughness);
      case SurfaceProperty::metallic:
        return glm::vec3(material.metallic);
      default:
        return glm::vec3(material.occlusion);
    }
  }
  // Uses the base colour texture's set of coordinates and transform, if there is one.
  [[nodiscard]] glm::vec2 uv_of(const Hit& hit) const {
    const World& world = scene_.world();
    const TextureUse& use = world.material_of(hit.triangle).base_color_texture;
    const int set = use.used() ? use.texcoord : 0;
    return texcoord_at(world, set, hit.triangle, hit.b1, hit.b2);
  }

  const RenderScene& scene_;
  SurfaceProperty property_;
  PixelSpacing spacing_;
  SampleExtent extent_;
};

}  // namespace

SurfacePicture surface_picture(const RenderScene& scene, const View& view, Culling faces,
                               SurfaceProperty property, SurfaceSampling sampling,
                               const std::stop_token& stop) {
  const int step = std::max(1, sampling.step), side = std::max(1, sampling.side);
  SurfacePicture picture{Film(view.width(), view.height()), {}};
  Film& film = picture.film;
  film.coverage.assign(film.radiance.size(), 0.0f);
  picture.wireframe.assign(film.radiance.size(), 0.0f);
  const double cell = static_cast<double>(step) / side;
  const Looker looker(scene, view, property, static_cast<float>(cell));
  const int across = (film.width + step - 1) / step;
  const World& world = scene.world();
  const bool has_ground = ground_of(world) != Ground::off;
  const auto ground = static_cast<std::uint32_t>(world.solid_parts()) - 1;
  const auto per_row = static_cast<std::size_t>(across) * static_cast<std::size_t>(side * side);
  std::vector<glm::dvec2> places(per_row);
  std::vector<Ray> rays(per_row);
  std::vector<Hit> hits(per_row);
  for (int y = 0; y < film.height && !stop.stop_requested(); y += step) {
    std::size_t n = 0;
    for (int x = 0; x < across; ++x)
      for (int i = 0; i < side * side; ++i)
        places[n++] = {step * x + (i % side + 0.5) * cell, y + (i / side + 0.5) * cell};
    view.rays(places, rays);
    scene.rays().closest(rays, hits, faces);
    for (int x = 0; x < across; ++x) {
      glm::vec3 sum(0.0f);
      float covered = 0.0f, lines = 0.0f;
      for (int i = 0; i < side * side; ++i) {
        const auto at = static_cast<std::size_t>(x) * static_cast<std::size_t>(side * side) +
                        static_cast<std::size_t>(i);
        if (!hits[at].valid()) continue;
        if (has_ground && world.triangle_part[hits[at].triangle] == ground) continue;
        const Looker::Seen seen = looker.look(rays[at], hits[at]);
        sum += seen.value;
        lines += seen.line;
        covered += 1.0f;
      }
      const float share = 1.0f / static_cast<float>(side * side);
      const glm::vec3 mean = covered > 0.0f ? sum / covered : glm::vec3(0.0f);
      const glm::vec3 shown = share * covered * (is_colour(property) ? mean : shown_as(mean));
      for (int v = y; v < std::min(y + step, film.height); ++v) {
        for (int u = step * x; u < std::min(step * (x + 1), film.width); ++u) {
          const std::size_t pixel = film.index(u, v);
          film.radiance[pixel] = shown;
          film.coverage[pixel] = share * covered;
          picture.wireframe[pixel] = share * lines;
        }
      }
    }
  }
  return picture;
}

}  // namespace asos
