#include "renderer/gltf/tidy_entries.h"

#include "renderer/gltf/kinds.h"

#include <climits>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace asos::gltf {

using nlohmann::json;

namespace {

// A number that no entry has.
constexpr unsigned no_entry = INT_MAX;

bool is_number_from_0(const json& value, double end) {
  return is_whole(value) && value.get<double>() >= 0.0 && value.get<double>() < end;
}

bool has_index(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && is_number_from_0(*found, no_entry);
}

bool has_number(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number();
}

bool has_text(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string();
}

/// Returns the fault of the object's first size that is not a whole number; empty: none.
std::string bad_size(const json& object) {
  for (const char* name : {"byteOffset", "byteLength", "byteStride", "count", "componentType"}) {
    const auto found = object.find(name);
    if (found == object.end() || found->is_null() || found->is_number_unsigned()) continue;
    if (is_number_from_0(*found, 9e15)) continue;
    return fmt::format("has a {} that is not a whole number", name);
  }
  return {};
}

/// Returns the object at `name`; null if there is none.
const json* object_in(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_object() ? &*found : nullptr;
}

// Each returns the fault of an entry, or an empty string.

std::string accessor_fault(const json& accessor) {
  if (!accessor.is_object()) return "is not an object";
  if (std::string why = bad_size(accessor); !why.empty()) return why;
  if (const json* sparse = object_in(accessor, "sparse")) {
    for (const json* part : {sparse, object_in(*sparse, "indices"), object_in(*sparse, "values")})
      if (std::string why = part ? bad_size(*part) : ""; !why.empty())
        return "has a sparse part that " + why;
  }
  constexpr std::array<std::string_view, 7> types = {"SCALAR", "VEC2", "VEC3", "VEC4",
                                                     "MAT2",   "MAT3", "MAT4"};
  const auto type = accessor.find("type");
  if (type == accessor.end()) return "has no type";
  if (!type->is_string() || std::find(types.begin(), types.end(), *type) == types.end())
    return "has an unknown type";
  const auto component = accessor.find("componentType");
  if (component == accessor.end() || component->is_null()) return "has no componentType";
  if (component->get<double>() < 5120.0 || component->get<double>() > 5130.0)
    return "has an unknown componentType";
  const auto count = accessor.find("count");
  return count == accessor.end() || count->is_null() ? "has no count" : "";
}

std::string view_fault(const json& view) {
  if (!view.is_object()) return "is not an object";
  if (std::string why = bad_size(view); !why.empty()) return why;
  if (!has_index(view, "buffer")) return "has no buffer";
  const auto length = view.find("byteLength");
  if (length == view.end() || length->is_null()) return "has no byteLength";
  const json* extensions = object_in(view, "extensions");
  const json* packed = extensions ? object_in(*extensions, "EXT_meshopt_compression") : nullptr;
  return packed ? bad_size(*packed) : "";
}

std::string validate_camera(const json& camera) {
  if (!camera.is_object()) return "is not an object";
  if (!has_text(camera, "type")) return "has no type";
  const std::string type = camera["type"].get<std::string>();
  if (type != "perspective" && type != "orthographic")
    return fmt::format("has the unknown type '{}'", type);
  const json* values = object_in(camera, type.c_str());
  if (!values) return fmt::format("has no '{}'", type);
  if (type == "perspective") return has_number(*values, "yfov") ? "" : "has no yfov";
  return has_number(*values, "xmag") && has_number(*values, "ymag") ? "" : "has no xmag or ymag";
}

class EntryTidier {
 public:
  EntryTidier(json& root, Warnings& warnings) : root_(root), warnings_(warnings) {}

  /// Replaces each entry of `list` by `by` if `fault_of` reports a fault.
  template <typename Fault>
  void replace(const char* list, const char* kind, const json& by, Fault fault_of) {
    each(root_, list, [&](json& entry, std::size_t i) {
      const std::string why = fault_of(entry);
      if (why.empty()) return;
      warnings_.add_loss(fmt::format("{} {} {}; left out", kind, i, why));
      entry = by;
    });
  }

  void replace_others() {
    constexpr std::array<const char*, 6> lists = {"nodes",    "scenes", "materials",
                                                  "textures", "skins",  "samplers"};
    for (const char* list : lists)
      each(root_, list, [&](json& entry, std::size_t i) { make_object(entry, list, i); });
  }

  void tidy_meshes() {
    each(root_, "meshes", [&](json& mesh, std::size_t m) {
      make_object(mesh, "meshes", m);
      each(mesh, "primitives", [&](json& primitive, std::size_t p) {
        make_object(primitive, fmt::format("meshes/{}/primitives", m), p);
      });
    });
  }

  void tidy_animations() {
    each(root_, "animations", [&](json& animation, std::size_t a) {
      make_object(animation, "animations", a);
      for (const char* list : {"channels", "samplers"})
        each(animation, list, [&](json& entry, std::size_t i) {
          make_object(entry, fmt::format("animations/{}/{}", a, list), i);
        });
      each(animation, "samplers", [&](json& sampler, std::size_t s) {
        for (const char* name : {"input", "output"}) {
          if (has_index(sampler, name)) continue;
          warnings_.add(fmt::format("animation {}, sampler {} has no {}", a, s, name));
          sampler[name] = no_entry;
        }
      });
    });
  }

  [[nodiscard]] std::set<std::size_t> tidy_cameras() {
    std::set<std::size_t> left_out;
    each(root_, "cameras", [&](json& camera, std::size_t i) {
      if (const std::string why = validate_camera(camera); !why.empty()) {
        warnings_.add(fmt::format("camera {} {}; left out", i, why));
        camera = {{"type", "perspective"}, {"perspective", {{"yfov", 0.0}, {"znear", 0.0}}}};
        left_out.insert(i);
      }
    });
    return left_out;
  }

  void tidy_lights() {
    const json::json_pointer place("/extensions/KHR_lights_punctual");
    if (!root_.contains(place)) return;
    each(root_[place], "lights", [&](json& light, std::size_t i) {
      if (!light.is_object()) light = json::object();
      // Nodes that use the light report that it is left out.
      if (!has_text(light, "type")) light["type"] = "";
      if (light["type"] != "spot" || object_in(light, "spot")) return;
      warnings_.add(fmt::format("light {} is a spot without angles; glTF's defaults are used", i));
      light["spot"] = json::object();
    });
  }

 private:
  template <typename Act>
  static void each(json& owner, const char* list, Act act) {
    const auto found = owner.is_object() ? owner.find(list) : owner.end();
    if (!owner.is_object() || found == owner.end() || !found->is_array()) return;
    for (std::size_t i = 0; i < found->size(); ++i) act((*found)[i], i);
  }

  void make_object(json& entry, const std::string& list, std::size_t i) {
    if (entry.is_object()) return;
    warnings_.add_loss(fmt::format("/{}/{} is not an object; left out", list, i));
    entry = json::object();
  }

  json& root_;
  Warnings& warnings_;
};

}  // namespace

std::set<std::size_t> tidy_entries(json& root, Warnings& warnings) {
  EntryTidier tidier(root, warnings);
  tidier.replace("accessors", "accessor",
                 {{"componentType", 5126u}, {"count", 0u}, {"type", "SCALAR"}}, accessor_fault);
  tidier.replace("bufferViews", "buffer view", {{"buffer", no_entry}, {"byteLength", 0u}},
                 view_fault);
  tidier.replace_others();
  tidier.tidy_meshes();
  tidier.tidy_animations();
  tidier.tidy_lights();
  return tidier.tidy_cameras();
}

void complete_planes(json& root, Warnings& warnings) {
  const auto cameras = root.find("cameras");
  if (cameras == root.end() || !cameras->is_array()) return;
  for (std::size_t i = 0; i < cameras->size(); ++i) {
    const auto complete = [&](const char* type, const char* name, double none) {
      const auto values = (*cameras)[i].find(type);
      if (values == (*cameras)[i].end() || !values->is_object() || has_number(*values, name))
        return;
      warnings.add(fmt::format("camera {} has no {}; it cuts nothing off there", i, name));
      (*values)[name] = none;
    };
    complete("perspective", "znear", 0.0);
    complete("orthographic", "znear", -1.0);
    complete("orthographic", "zfar", -1.0);
  }
}

}  // namespace asos::gltf
