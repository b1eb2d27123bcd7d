#include "renderer/prepared/edited_materials.h"

#include <fmt/format.h>

#include <cstddef>
#include <new>
#include <string>

namespace asos {

MaterialDfrs dfrs_of(const World& world) {
  MaterialDfrs dfrs;
  for (const Material& material : world.materials) dfrs.push_back(material.dfr);
  return dfrs;
}

Result<std::shared_ptr<const RenderScene>> with_dfrs(
    const std::shared_ptr<const RenderScene>& scene, const MaterialDfrs& dfrs) {
  const std::size_t count = scene->world.materials.size();
  if (dfrs.size() != count)
    return unexpected(
        Error{"materials", fmt::format("{} ratios for {} materials", dfrs.size(), count)});
  for (std::size_t i = 0; i < count; ++i) {
    RenderSettings settings;
    settings.mirror.dfr = dfrs[i];
    if (const auto sound = validated(settings); !sound)
      return unexpected(
          Error{"material '" + scene->world.materials[i].name + "'", sound.error().message()});
  }
  try {
    auto edited = std::make_shared<RenderScene>(*scene);
    edited->built_from = scene->built_from ? scene->built_from : scene;
    for (std::size_t i = 0; i < count; ++i) edited->world.materials[i].dfr = dfrs[i];
    return edited;
  } catch (const std::bad_alloc&) {
    return unexpected(Error{scene->source, "does not fit into this machine's memory"});
  }
}

}  // namespace asos
