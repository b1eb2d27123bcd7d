#pragma once

#include "renderer/gltf/images.h"

#include <string>
#include <utility>

namespace asos::gltf {

/// Reads numbers and textures of one material. A value out of range is clamped with a warning.
class MaterialValues {
 protected:
  /// `place` is the material's, for messages. The references have to outlive this.
  MaterialValues(std::string place, Textures& textures, Warnings& warnings)
      : place_(std::move(place)), textures_(textures), warnings_(warnings) {}

  /// Returns `value` as a float, or `otherwise` if it does not fit.
  float finite(double value, double otherwise, const char* what);
  /// Returns `value`, or the nearest value from `low` to `high`.
  float within(double value, double low, double high, double otherwise, const char* what);

  /// `Info` is one of tinygltf's texture references, which share these members.
  template <typename Info>
  TextureUse use(const Info& info, const char* what) {
    return use(info.index, info.texCoord, info.extensions, what);
  }
  /// Returns the use of an extension's texture.
  TextureUse use_in(const tinygltf::Value& parent, const char* name, const char* what);

  std::string place_;
  Textures& textures_;
  Warnings& warnings_;

 private:
  TextureUse use(int index, int texcoord, const tinygltf::ExtensionMap& extensions,
                 const char* what);
  glm::mat3 transform(const tinygltf::Value& e);
};

}  // namespace asos::gltf
