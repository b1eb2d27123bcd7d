#pragma once

#include "renderer/scene/gltf/accessors.h"
#include "renderer/scene/gltf/image_limits.h"
#include "renderer/scene/scene.h"

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace asos::gltf {

/// Decodes a PNG, JPEG or WebP to 8-bit RGBA (16-bit PNGs lose their lower half). Faults: another
/// format, broken data, and dimensions that the bytes cannot stand for or that are more than
/// `most_pixels`, before they are allocated.
[[nodiscard]] Checked<Image> decode_image(Bytes bytes,
                                          std::uint64_t most_pixels = any_number_of_pixels);

/// What `use` makes of the bytes of one of the document's images; a fault where there are none.
template <typename Use>
[[nodiscard]] Checked<Image> with_image_bytes(Document& document, Accessors& accessors, int index,
                                              const Use& use) {
  if (index < 0 || static_cast<std::size_t>(index) >= document.images.size())
    return fault("it does not exist");
  const ImageSource& source = document.images[static_cast<std::size_t>(index)];
  if (source.buffer_view >= 0) {
    const Checked<Bytes> bytes = accessors.view(source.buffer_view);
    if (!bytes) return fault(bytes.error());
    return use(*bytes);
  }
  const Checked<FileBytes> bytes = read_uri(document.folder, source.uri);
  if (!bytes) return fault(bytes.error());
  return use(Bytes(*bytes));
}

/// Takes over a document's textures as materials ask for them, so that images that nothing shows
/// are neither decoded nor kept.
class Textures {
 public:
  Textures(Document& document, Accessors& accessors, Scene& scene);

  /// The scene's texture for one of the document's, or -1 with a warning where it has no usable
  /// image: the material is then drawn without it.
  [[nodiscard]] int use(int texture);

  /// A texture whose green is the roughness 1 - factor * alpha of one of the scene's textures
  /// (KHR_materials_pbrSpecularGlossiness), `factor` 0 to 1. -1 with a warning where one image is
  /// to be turned by more factors than files have use for, each of which takes its memory again.
  [[nodiscard]] int roughness_of(int texture, float factor);

 private:
  /// Bytes of a buffer, or a file: images that share theirs are one.
  using ImagePlace = std::tuple<const std::uint8_t*, std::size_t, std::string>;

  [[nodiscard]] int load(int texture);
  [[nodiscard]] int image_of(const tinygltf::Texture& texture, int index);
  [[nodiscard]] int use_image(int image);
  [[nodiscard]] Checked<int> add_image(int image);
  [[nodiscard]] ImagePlace place_of(const ImageSource& source);
  [[nodiscard]] std::uint64_t pixels_left() const;

  Document& doc_;
  Accessors& accessors_;
  Scene& scene_;
  std::vector<int> texture_of_;  // by document texture: unknown, or the scene's
  std::vector<int> image_of_;
  std::map<ImagePlace, int> image_at_;  // the scene's, by where its bytes are
  std::uint64_t pixels_ = 0;            // of all
  std::uint64_t outside_bytes_ = 0;     // of those in files of their own
  std::map<int, std::vector<std::pair<float, int>>> roughness_of_;  // by image: factor, image
};

}  // namespace asos::gltf
