#include "renderer/gltf/shapes.h"

#include "renderer/gltf/values.h"

#include <fmt/format.h>

#include <array>
#include <string>

namespace asos::gltf {
namespace {

constexpr const char* node_extension = "ASOS_implicit_shape";
constexpr const char* root_extension = "KHR_implicit_shapes";

/// Returns a number, or `otherwise` if the property is missing; anything else is an error.
Checked<double> size_or(const tinygltf::Value& source, const char* name, double otherwise) {
  if (!source.Has(name)) return otherwise;
  if (const auto value = number(source, name)) return *value;
  return fault(fmt::format("has a {} that is not a number", name));
}

Checked<void> read_box(const tinygltf::Value& source, Shape& shape) {
  if (!source.Has("size")) return {};
  const tinygltf::Value& size = source.Get("size");
  const bool three = size.IsArray() && size.ArrayLen() == 3;
  for (int k = 0; k < 3; ++k) {
    const auto value = three ? number_at(source, "size", k) : std::nullopt;
    if (!value) return fault("has a size that is not three numbers");
    shape.size[k] = *value;
  }
  return {};
}

/// Reads `names` into the doubles paired with them, which contain the defaults.
template <std::size_t count>
Checked<void> read_sizes(const tinygltf::Value& source,
                         const std::array<std::pair<const char*, double*>, count>& names) {
  for (const auto& [name, value] : names) {
    const Checked<double> read = size_or(source, name, *value);
    if (!read) return fault(read.error());
    *value = *read;
  }
  return {};
}

/// Reads a shape of KHR_implicit_shapes (defaults included) from the object with its sizes.
Checked<Shape> read_sizes_of(const std::string& type, const tinygltf::Value& source) {
  Shape shape;
  Checked<void> done;
  if (type == "sphere" || type == "disk") {
    shape.type = type == "disk" ? Shape::Type::disk : Shape::Type::sphere;
    done = read_sizes(source, std::array{std::pair{"radius", &shape.radius}});
  } else if (type == "box") {
    shape.type = Shape::Type::box;
    done = read_box(source, shape);
  } else if (type == "cylinder") {
    shape.type = Shape::Type::cylinder;
    done = read_sizes(source, std::array{std::pair{"height", &shape.height},
                                         std::pair{"radiusBottom", &shape.radius_bottom},
                                         std::pair{"radiusTop", &shape.radius_top}});
  } else {
    return fault(fmt::format("has the type '{}', which is not drawn as a shape", type));
  }
  if (!done) return fault(done.error());
  if (const std::string why = validate_shape(shape); !why.empty()) return fault("is none: " + why);
  return shape;
}

Checked<Shape> read_extension(const Document& document, const tinygltf::Value& reference) {
  const int index = whole(reference, "shape").value_or(-1);
  const tinygltf::Value* root = extension(document.model.extensions, root_extension);
  const bool listed = root && root->Has("shapes") && root->Get("shapes").IsArray() && index >= 0 &&
                      static_cast<std::size_t>(index) < root->Get("shapes").ArrayLen() &&
                      root->Get("shapes").Get(index).IsObject();
  if (!listed)
    return fault(
        fmt::format("is number {} of {}, which the file does not define", index, root_extension));
  const tinygltf::Value& source = root->Get("shapes").Get(index);
  const std::string type = text(source, "type");
  const bool has_sizes = source.Has(type) && source.Get(type).IsObject();
  return read_sizes_of(type,
                       has_sizes ? source.Get(type) : tinygltf::Value(tinygltf::Value::Object()));
}

Checked<Shape> read_extras(const tinygltf::Value& source) {
  if (!source.IsObject()) return fault("is not an object");
  return read_sizes_of(text(source, "type"), source);
}

}  // namespace

std::optional<Shape> node_shape(Document& document, const tinygltf::Node& node) {
  const auto warn = [&](const char* where, const std::string& why) {
    const auto index = &node - document.model.nodes.data();
    document.warnings.add(
        fmt::format("node {} '{}': the shape {} {}", index, node.name, where, why));
  };
  const auto read = [&](const char* where, const Checked<Shape>& shape) -> std::optional<Shape> {
    if (shape) return *shape;
    warn(where, shape.error());
    return std::nullopt;
  };
  std::optional<Shape> shape, repeated;
  if (const tinygltf::Value* reference = extension(node.extensions, node_extension))
    shape = read("of its extension", read_extension(document, *reference));
  if (node.extras.IsObject() && node.extras.Has("asos_shape"))
    repeated = read("in its extras", read_extras(node.extras.Get("asos_shape")));
  // A program that knows the extension may have edited it and left the extras unchanged.
  if (shape && repeated && *shape != *repeated)
    warn("in its extras", "is another one than that of its extension, which holds");
  return shape ? shape : repeated;
}

}  // namespace asos::gltf
