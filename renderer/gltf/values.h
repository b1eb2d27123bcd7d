#pragma once

#include "renderer/gltf/tinygltf.h"

#include <cmath>
#include <optional>
#include <string>

// Access to the `extensions` and `extras` that tinygltf stores as generic values. A value of
// another type than the requested one counts as missing.

namespace asos::gltf {

inline const tinygltf::Value* extension(const tinygltf::ExtensionMap& extensions,
                                        const std::string& name) {
  const auto found = extensions.find(name);
  return found != extensions.end() && found->second.IsObject() ? &found->second : nullptr;
}

/// Returns an extension of an object within an extension.
inline const tinygltf::Value* extension(const tinygltf::Value& object, const std::string& name) {
  if (!object.Has("extensions") || !object.Get("extensions").Has(name)) return nullptr;
  const tinygltf::Value& found = object.Get("extensions").Get(name);
  return found.IsObject() ? &found : nullptr;
}

inline std::optional<double> number(const tinygltf::Value& object, const std::string& name) {
  if (!object.Has(name)) return std::nullopt;
  const tinygltf::Value& value = object.Get(name);
  if (!value.IsNumber() || !std::isfinite(value.GetNumberAsDouble())) return std::nullopt;
  return value.GetNumberAsDouble();
}

inline std::optional<int> whole(const tinygltf::Value& object, const std::string& name) {
  if (!object.Has(name) || !object.Get(name).IsInt()) return std::nullopt;
  return object.Get(name).GetNumberAsInt();
}

inline std::optional<bool> flag(const tinygltf::Value& object, const std::string& name) {
  if (!object.Has(name) || !object.Get(name).IsBool()) return std::nullopt;
  return object.Get(name).Get<bool>();
}

inline std::string text(const tinygltf::Value& object, const std::string& name,
                        const std::string& otherwise = "") {
  if (!object.Has(name) || !object.Get(name).IsString()) return otherwise;
  return object.Get(name).Get<std::string>();
}

/// Returns element `i` of the list `name`, if it is a number.
inline std::optional<double> number_at(const tinygltf::Value& object, const std::string& name,
                                       int i) {
  if (!object.Has(name) || !object.Get(name).IsArray()) return std::nullopt;
  const tinygltf::Value& value = object.Get(name).Get(i);
  if (!value.IsNumber() || !std::isfinite(value.GetNumberAsDouble())) return std::nullopt;
  return value.GetNumberAsDouble();
}

}  // namespace asos::gltf
