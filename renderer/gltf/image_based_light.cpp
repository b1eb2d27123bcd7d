#include "renderer/gltf/image_based_light.h"

#include "renderer/gltf/images.h"
#include "renderer/gltf/pictures/picture.h"
#include "renderer/gltf/texture_budget.h"
#include "renderer/gltf/values.h"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <utility>

namespace asos::gltf {

namespace {

constexpr const char* extension_name = "EXT_lights_image_based";
constexpr int coefficients = 9;
constexpr int most_pixels_a_side = 4096;

/// Returns a list with exactly `count` entries; null if there is none.
const tinygltf::Value* list_of(const tinygltf::Value& object, const char* name, std::size_t count) {
  if (!object.Has(name)) return nullptr;
  const tinygltf::Value& list = object.Get(name);
  return list.IsArray() && list.ArrayLen() == count ? &list : nullptr;
}

Checked<glm::dmat3> rotation_of(const tinygltf::Value& light) {
  if (!light.Has("rotation")) return glm::dmat3(1.0);
  glm::dvec4 q(0.0);
  for (int i = 0; i < 4; ++i) {
    const auto value =
        list_of(light, "rotation", 4) ? number_at(light, "rotation", i) : std::nullopt;
    if (!value) return fault("its rotation is not four numbers");
    q[i] = *value;
  }
  const double length = glm::length(q);
  if (!(length > 1e-12) || !std::isfinite(length)) return fault("its rotation is no quaternion");
  q /= length;
  return glm::mat3_cast(glm::dquat(q.w, q.x, q.y, q.z));
}

Checked<float> intensity_of(const tinygltf::Value& light) {
  if (!light.Has("intensity")) return 1.0f;
  const auto value = number(light, "intensity");
  if (!value || !(*value >= 0.0) || !(*value <= 1e30))
    return fault("its intensity is no number from 0 to 1e30");
  return static_cast<float>(*value);
}

/// Checks the coefficients. They are not used, since surfaces use the pictures' own irradiance, but
/// a light must have them.
Checked<void> check_coefficients(const tinygltf::Value& light) {
  const auto* list = list_of(light, "irradianceCoefficients", coefficients);
  for (int i = 0; list && i < coefficients; ++i) {
    const tinygltf::Value& rgb = list->Get(i);
    bool sound = rgb.IsArray() && rgb.ArrayLen() == 3;
    for (int c = 0; sound && c < 3; ++c)
      sound = rgb.Get(c).IsNumber() && std::isfinite(rgb.Get(c).GetNumberAsDouble());
    if (!sound) list = nullptr;
  }
  if (!list) return fault("its irradianceCoefficients are not 9 times 3 numbers");
  return {};
}

/// Returns whether a PNG has an alpha channel, from its signature and the head of its first chunk:
/// width, height, bits, type.
bool has_alpha(Bytes bytes) {
  constexpr std::size_t type_at = 25;
  constexpr std::uint8_t colours_and_alpha = 6;
  return bytes.size() > type_at && bytes[0] == 0x89 && bytes[1] == 'P' &&
         bytes[type_at] == colours_and_alpha;
}

class SidesReader {
 public:
  SidesReader(Document& document, Accessors& accessors) : doc_(document), accessors_(accessors) {}

  Checked<void> read(const tinygltf::Value& light, EnvironmentCube& surroundings) {
    if (!light.Has("specularImages") || !light.Get("specularImages").IsArray() ||
        light.Get("specularImages").ArrayLen() == 0)
      return fault("it has no specularImages");
    const tinygltf::Value& largest = light.Get("specularImages").Get(0);
    if (!largest.IsArray() || largest.ArrayLen() != surroundings.sides.size())
      return fault("the first of its specularImages are not six images");
    for (std::size_t i = 0; i < surroundings.sides.size(); ++i) {
      const tinygltf::Value& index = largest.Get(static_cast<int>(i));
      if (!index.IsInt()) return fault("the first of its specularImages are not six images");
      Checked<EnvironmentCube::Side> side = read_side(index.GetNumberAsInt());
      if (!side) return fault(side.error());
      const int size = surroundings.sides[0].image.width;
      if (i > 0 && side->image.width != size)
        return fault(fmt::format("its images are {} and {} pixels wide, and not all the same", size,
                                 side->image.width));
      surroundings.sides[i] = std::move(*side);
    }
    if (const auto size = whole(light, "specularImageSize");
        !size || *size != surroundings.sides[0].image.width) {
      doc_.warnings.add(
          fmt::format("{}: its specularImageSize is not the {} pixels of its images; they count",
                      extension_name, surroundings.sides[0].image.width));
    }
    return {};
  }

 private:
  Checked<EnvironmentCube::Side> read_side(int index) {
    const Checked<ImageBytes> bytes = image_bytes(doc_, accessors_, index);
    if (!bytes) return fault(fmt::format("its image {}: {}", index, bytes.error()));
    const PictureResult<PictureHead> head = picture_head(bytes->bytes);
    if (!head) return fault(fmt::format("its image {}: {}", index, head.error()));
    if (head->width != head->height)
      return fault(fmt::format("its image {} is {} x {} pixels and not square", index, head->width,
                               head->height));
    if (head->width > most_pixels_a_side)
      return fault(fmt::format("its image {} is {} pixels wide; the limit is {}", index,
                               head->width, most_pixels_a_side));
    bytes_ += bytes->bytes.size();
    texels_ += head->pixels();
    if (texels_ > most_texels(bytes_))
      return fault(
          fmt::format("its images of {} pixels a side are more than a file of this size "
                      "has use for",
                      head->width));
    PictureResult<Picture> picture = read_picture(bytes->bytes);
    if (!picture) return fault(fmt::format("its image {}: {}", index, picture.error()));
    if (!picture->remark.empty())
      doc_.warnings.add(
          fmt::format("image {} of the image-based light: {}", index, picture->remark));
    return EnvironmentCube::Side{std::move(picture->image), has_alpha(bytes->bytes)};
  }

  std::uint64_t bytes_ = 0, texels_ = 0;  // of all sides so far
  Document& doc_;
  Accessors& accessors_;
};

Checked<std::shared_ptr<const EnvironmentCube>> read_light(Document& document, Accessors& accessors,
                                                           int index) {
  const tinygltf::Value* all = extension(document.model.extensions, extension_name);
  if (!all || index < 0 || !all->Has("lights") || !all->Get("lights").IsArray() ||
      static_cast<std::size_t>(index) >= all->Get("lights").ArrayLen())
    return fault("it does not exist");
  const tinygltf::Value& light = all->Get("lights").Get(index);
  if (!light.IsObject()) return fault("it is no object");
  auto surroundings = std::make_shared<EnvironmentCube>();
  surroundings->name = text(light, "name");
  const Checked<glm::dmat3> rotation = rotation_of(light);
  if (!rotation) return fault(rotation.error());
  surroundings->world_from_cube = *rotation;
  const Checked<float> intensity = intensity_of(light);
  if (!intensity) return fault(intensity.error());
  surroundings->intensity = *intensity;
  if (auto sound = check_coefficients(light); !sound) return fault(sound.error());
  if (auto read = SidesReader(document, accessors).read(light, *surroundings); !read)
    return fault(read.error());
  return surroundings;
}

}  // namespace

std::shared_ptr<const EnvironmentCube> image_based_light(Document& document, Accessors& accessors,
                                                         int scene) {
  if (scene < 0 || static_cast<std::size_t>(scene) >= document.model.scenes.size()) return nullptr;
  const auto* named =
      extension(document.model.scenes[static_cast<std::size_t>(scene)].extensions, extension_name);
  if (!named) return nullptr;
  const int index = whole(*named, "light").value_or(-1);
  auto light = read_light(document, accessors, index);
  if (light) return *light;
  document.warnings.add(fmt::format("image-based light {} is left out: {}", index, light.error()));
  return nullptr;
}

}  // namespace asos::gltf
