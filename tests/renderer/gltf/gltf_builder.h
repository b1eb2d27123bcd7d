#pragma once

#include "tests/support/temporary_folder.h"

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace asos::test {

/// Builds a glTF file: numbers go into a single binary buffer, everything else is JSON.
struct GltfBuilder {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}},
                         {"scene", 0},
                         {"scenes", {{{"nodes", {0}}}}},
                         {"nodes", {{{"mesh", 0}}}},
                         {"meshes", {{{"primitives", nlohmann::json::array()}}}},
                         {"accessors", nlohmann::json::array()},
                         {"bufferViews", nlohmann::json::array()}};
  std::string bin;

  int view(const void* data, std::size_t bytes) {
    while (bin.size() % 4 != 0) bin.push_back('\0');
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes}});
    bin.append(static_cast<const char*>(data), bytes);
    return static_cast<int>(json["bufferViews"].size()) - 1;
  }
  template <typename T>
  int view(const std::vector<T>& values) {
    return view(values.data(), values.size() * sizeof(T));
  }
  int accessor(int buffer_view, int component_type, const char* type, std::size_t count,
               bool normalized = false) {
    nlohmann::json a = {{"componentType", component_type}, {"type", type}, {"count", count}};
    if (buffer_view >= 0) a["bufferView"] = buffer_view;
    if (normalized) a["normalized"] = true;
    json["accessors"].push_back(a);
    return static_cast<int>(json["accessors"].size()) - 1;
  }
  int vec3(const std::vector<glm::vec3>& v) { return accessor(view(v), 5126, "VEC3", v.size()); }
  int vec2(const std::vector<glm::vec2>& v) { return accessor(view(v), 5126, "VEC2", v.size()); }
  int vec4(const std::vector<glm::vec4>& v) { return accessor(view(v), 5126, "VEC4", v.size()); }
  int scalars(const std::vector<float>& v) { return accessor(view(v), 5126, "SCALAR", v.size()); }
  int mat4(const std::vector<glm::mat4>& v) { return accessor(view(v), 5126, "MAT4", v.size()); }
  int indices(const std::vector<std::uint16_t>& v) {
    return accessor(view(v), 5123, "SCALAR", v.size());
  }
  nlohmann::json& primitive(nlohmann::json attributes, int mode = 4) {
    auto& list = json["meshes"][0]["primitives"];
    list.push_back({{"attributes", std::move(attributes)}, {"mode", mode}});
    return list.back();
  }
  nlohmann::json& node() { return json["nodes"][0]; }

  /// A unit square of two triangles in the plane z = 0, facing +Z.
  static GltfBuilder square() {
    GltfBuilder b;
    const int p = b.vec3({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    const int n = b.vec3(std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
    const int i = b.indices({0, 1, 2, 0, 2, 3});
    b.primitive({{"POSITION", p}, {"NORMAL", n}})["indices"] = i;
    return b;
  }

  [[nodiscard]] std::string glb() const {
    nlohmann::json whole = json;
    if (!bin.empty()) whole["buffers"] = {{{"byteLength", bin.size()}}};
    std::string text = whole.dump(), data = bin;
    while (text.size() % 4 != 0) text.push_back(' ');
    while (data.size() % 4 != 0) data.push_back('\0');
    std::string out = "glTF";
    const auto put = [&](std::size_t value) {
      const auto word = static_cast<std::uint32_t>(value);
      out.append(reinterpret_cast<const char*>(&word), 4);
    };
    put(2);
    put(12 + 8 + text.size() + (data.empty() ? 0 : 8 + data.size()));
    put(text.size());
    out += "JSON" + text;
    if (data.empty()) return out;
    put(data.size());
    out += std::string("BIN\0", 4) + data;
    return out;
  }

  /// The file as .gltf, with its buffer in `bin_uri` or, by default, embedded.
  [[nodiscard]] std::string gltf(const std::string& bin_uri = "") const {
    nlohmann::json whole = json;
    const std::string uri =
        bin_uri.empty() ? "data:application/octet-stream;base64," + base64(bin) : bin_uri;
    whole["buffers"] = {{{"byteLength", bin.size()}, {"uri", uri}}};
    return whole.dump();
  }

  static std::string base64(const std::string& bytes) {
    static const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        bits = bits << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
      }
      for (std::size_t k = 0; k < 4; ++k) {
        out.push_back(i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=');
      }
    }
    return out;
  }
};

/// 2 x 2 pixels: red, green; blue, white.
inline constexpr const char* small_png =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEklEQVR4nGP4z8DAAMIM/"
    "4EAAB/uBfsL2WiLAAAAAElFTkSuQmCC";

}  // namespace asos::test
