#include "renderer/prepared/geometry.h"

#include "renderer/shading/shade.h"
#include "renderer/shading/texture.h"

#include <cstddef>
#include <future>
#include <utility>

namespace asos {
namespace {

template <typename T>
std::size_t bytes_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

std::size_t bytes_of(const World& world) {
  std::size_t bytes =
      bytes_of(world.positions) + bytes_of(world.normals) + bytes_of(world.tangents) +
      bytes_of(world.texcoords[0]) + bytes_of(world.texcoords[1]) + bytes_of(world.colors) +
      bytes_of(world.triangles) + bytes_of(world.triangle_part) + bytes_of(world.parts);
  for (const Image& image : world.images) bytes += bytes_of(image.rgba);
  return bytes;
}

double megabytes_of(const Geometry& geometry) {
  const std::size_t bytes = bytes_of(geometry.world) + geometry.mips.memory_bytes() +
                            geometry.rays.memory_bytes() + geometry.features.memory_bytes() +
                            bytes_of(geometry.object_spheres);
  return static_cast<double>(bytes) / (1024.0 * 1024.0);
}

}  // namespace

Result<std::shared_ptr<Geometry>> build_geometry(World world, std::span<const Light> lights,
                                                 const SceneNeeds& forced) {
  auto geometry = std::make_shared<Geometry>();
  geometry->needs = find_needs(world);  // White colours that are asked for are not colours.
  if (!forced.unused_images) release_unused_images(world);
  fill_forced_attributes(world, forced);
  geometry->world = std::move(world);

  // Neither of the three needs another.
  auto features = std::async(std::launch::async, [&] {
    return FeatureSet(geometry->world, [](const World& w, const TextureUse& use,
                                          std::uint32_t triangle, float b1, float b2) {
      return sample_texture(w, use, triangle, b1, b2, Encoding::linear);
    });
  });
  auto mips = std::async(std::launch::async,
                         [&] { return MipChains(geometry->world, geometry->needs.with(forced)); });
  geometry->object_spheres = object_spheres(geometry->world);
  auto rays = RayScene::build(geometry->world, alpha_at, lights, forced);
  geometry->features = features.get();
  geometry->mips = mips.get();
  if (!rays) return unexpected(rays.error());
  geometry->rays = std::move(*rays);

  geometry->needs.intersections =
      geometry->features.counts().intersection > 0 || !geometry->features.intersections_complete();
  geometry->memory_mb = megabytes_of(*geometry);
  return geometry;
}

}  // namespace asos
