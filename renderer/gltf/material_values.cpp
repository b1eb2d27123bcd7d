#include "renderer/gltf/material_values.h"

#include "renderer/gltf/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asos::gltf {

float MaterialValues::finite(double value, double otherwise, const char* what) {
  const auto single = static_cast<float>(value);
  if (std::isfinite(single)) return single;
  warnings_.add(fmt::format("{}: its {} is not finite", place_, what));
  return static_cast<float>(otherwise);
}

float MaterialValues::within(double value, double low, double high, double otherwise,
                             const char* what) {
  const double number = static_cast<double>(finite(value, otherwise, what));
  const double clamped = std::clamp(number, low, high);
  if (clamped != number) {
    warnings_.add(
        fmt::format("{}: its {} of {} is out of range; {} is used", place_, what, number, clamped));
  }
  return static_cast<float>(clamped);
}

TextureUse MaterialValues::use(int index, int texcoord, const tinygltf::ExtensionMap& extensions,
                               const char* what) {
  TextureUse use;
  if (index < 0) return use;
  use.texcoord = texcoord;
  if (const auto* e = extension(extensions, "KHR_texture_transform")) {
    use.texcoord = whole(*e, "texCoord").value_or(use.texcoord);
    use.uv_transform = transform(*e);
  }
  if (use.texcoord < 0 || use.texcoord > 1) {
    warnings_.add(
        fmt::format("{}: its {} texture uses TEXCOORD_{}; only 0 and 1 are supported, "
                    "so it is left out",
                    place_, what, use.texcoord));
    return {};
  }
  use.texture = textures_.use(index);
  return use;
}

TextureUse MaterialValues::use_in(const tinygltf::Value& parent, const char* name,
                                  const char* what) {
  if (!parent.Has(name)) return {};
  const tinygltf::Value& value = parent.Get(name);
  tinygltf::TextureInfo info;
  info.index = whole(value, "index").value_or(-1);
  if (info.index < 0)
    warnings_.add(fmt::format("{}: its {} texture names no texture", place_, what));
  info.texCoord = whole(value, "texCoord").value_or(0);
  if (const auto* e = extension(value, "KHR_texture_transform"))
    info.extensions["KHR_texture_transform"] = *e;
  return use(info, what);
}

glm::mat3 MaterialValues::transform(const tinygltf::Value& e) {
  const auto at = [&](const char* name, int i, double otherwise) {
    return finite(number_at(e, name, i).value_or(otherwise), otherwise, "texture transform");
  };
  const float x = at("offset", 0, 0.0), y = at("offset", 1, 0.0);
  const float sx = at("scale", 0, 1.0), sy = at("scale", 1, 1.0);
  const float angle = finite(number(e, "rotation").value_or(0.0), 0.0, "texture transform");
  const float c = std::cos(angle), s = std::sin(angle);
  // Translation * rotation * scale, in columns. The rotation is counter-clockwise in the picture,
  // whose v points down.
  return {glm::vec3(c * sx, -s * sx, 0.0f), glm::vec3(s * sy, c * sy, 0.0f), glm::vec3(x, y, 1.0f)};
}

}  // namespace asos::gltf
