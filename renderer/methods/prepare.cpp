#include "renderer/methods/render_scene.h"
#include "renderer/shading/default_rig.h"
#include "renderer/shading/shade.h"
#include "renderer/shading/texture.h"

#include <chrono>
#include <cstddef>
#include <future>
#include <new>
#include <utility>
#include <vector>

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

Result<std::shared_ptr<const RenderScene>> prepare_in_memory(const Scene& scene) {
  const auto start = std::chrono::steady_clock::now();
  auto world = flatten(scene);
  if (!world) return unexpected(world.error());

  auto prepared = std::make_shared<RenderScene>();
  prepared->world = std::move(*world);
  prepared->name = scene.name;
  prepared->source = scene.source;
  prepared->notes = scene.notes;

  if (prepared->world.lights.empty()) {
    const World& w = prepared->world;
    prepared->default_rig = true;
    prepared->world.lights =
        default_rig(w.cameras.empty() ? default_camera(w, 16.0 / 9.0) : w.cameras.front());
  }
  prepared->needs = find_needs(prepared->world);

  // Neither of the three needs another.
  auto features = std::async(std::launch::async, [&] {
    return FeatureSet(prepared->world, [](const World& w, const TextureUse& use,
                                          std::uint32_t triangle, float b1, float b2) {
      return sample_texture(w, use, triangle, b1, b2, Encoding::linear);
    });
  });
  auto mips =
      std::async(std::launch::async, [&] { return MipChains(prepared->world, prepared->needs); });
  auto rays = RayScene::build(prepared->world, alpha_at);
  prepared->features = features.get();
  prepared->mips = mips.get();
  if (!rays) return unexpected(Error{scene.source, rays.error().message()});
  prepared->rays = std::move(*rays);
  if (!prepared->features.intersections_complete()) {
    prepared->notes.warnings.emplace_back(
        "surfaces pass through each other or overlap too often; the lines where "
        "they do are found by samples only");
  }

  const std::size_t bytes = bytes_of(prepared->world) + prepared->mips.memory_bytes() +
                            prepared->rays.memory_bytes() + prepared->features.memory_bytes();
  prepared->memory_mb = static_cast<double>(bytes) / (1024.0 * 1024.0);
  prepared->build_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return prepared;
}

}  // namespace

Result<std::shared_ptr<const RenderScene>> prepare(const Scene& scene) {
  try {
    return prepare_in_memory(scene);
  } catch (const std::bad_alloc&) {
    return unexpected(Error{scene.source, "does not fit into this machine's memory"});
  }
}

}  // namespace asos
