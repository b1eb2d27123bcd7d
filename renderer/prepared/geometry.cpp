#include "renderer/prepared/geometry.h"

#include "renderer/shading/shade.h"
#include "renderer/shading/texture.h"
#include "renderer/work_counts.h"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace asos {
namespace {

template <typename T>
std::size_t bytes_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

std::size_t bytes_of(const World& world) {
  std::size_t bytes = geometry_bytes(world);
  for (const Image& image : world.images)
    bytes += bytes_of(image.rgba.get()) + bytes_of(image.low.get());
  return bytes;
}

// Returns the encoded texel values, so that differences are those on a display.
glm::vec4 stored_texture(const World& world, const TextureUse& use, std::uint32_t triangle,
                         float b1, float b2) {
  return sample_texture(world, use, triangle, b1, b2, Encoding::linear);
}

}  // namespace

double Geometry::memory_mb() const {
  std::size_t bytes =
      bytes_of(world) + mips.memory_bytes() + rays.memory_bytes() + bytes_of(object_spheres);
  if (boundaries.known()) bytes += boundaries.get().memory_bytes();
  return static_cast<double>(bytes) / (1024.0 * 1024.0);
}

Result<std::shared_ptr<Geometry>> build_geometry(World world, std::span<const Light> lights,
                                                 const RenderFeatures& forced,
                                                 const MipChains* known, BvhPurpose use,
                                                 const RayScene* known_rays) {
  WorkDone::add(Work::geometries);
  auto geometry = std::make_shared<Geometry>();
  geometry->render_features =
      find_render_features(world);  // White colours that are forced do not count as colours.
  if (!forced.unused_images) release_unused_images(world);
  fill_forced_attributes(world, forced);
  geometry->world = std::move(world);

  geometry->mips = MipChains(geometry->world, geometry->render_features.with(forced), known);
  geometry->object_spheres = object_spheres(geometry->world);
  auto rays =
      RayScene::build(geometry->world, alpha_at, lights, forced, passage_at, use, known_rays);
  if (!rays) return unexpected(rays.error());
  geometry->rays = std::move(*rays);

  geometry->boundaries.find([&world = geometry->world](const std::stop_token& stop) {
    WorkDone::add(Work::boundary_searches);
    return FeatureSet(world, stored_texture, stop);
  });
  return geometry;
}

}  // namespace asos
