#pragma once

#include "renderer/gltf/accessors.h"
#include "renderer/scene/scene.h"

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace asos::gltf {

/// The bytes of one of the document's images; `read` is what holds them where they are not part of
/// a buffer.
struct ImageBytes {
  FileBytes read;
  Bytes bytes;
  std::string remark;  ///< see UriBytes
};
/// A fault where there are none.
[[nodiscard]] Checked<ImageBytes> image_bytes(Document& document, Accessors& accessors, int index);

/// Takes over a document's textures as materials ask for them, so that images that nothing shows
/// are neither decoded nor kept. Where all images of the file are more than it has use for, the
/// largest are reduced as they are read, with a warning (texture_budget.h).
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
  [[nodiscard]] Checked<ImageBytes> take_bytes(int image);
  [[nodiscard]] ImagePlace place_of(const ImageSource& source);
  void plan();
  [[nodiscard]] std::string name_of(int image) const;

  Document& doc_;
  Accessors& accessors_;
  Scene& scene_;
  std::vector<int> texture_of_;  // by document texture: unknown, or the scene's
  std::vector<int> image_of_;
  std::map<ImagePlace, int> image_at_;  // the scene's, by where its bytes are
  std::vector<int> shrinks_;            // by document image, when there is a plan
  std::map<int, ImageBytes> read_;      // by document image: of files, read for the plan
  std::uint64_t all_bytes_ = 0;         // of images as they are stored
  std::uint64_t copied_texels_ = 0;     // of `roughness_of`
  std::map<int, std::vector<std::pair<float, int>>> roughness_of_;  // by image: factor, image
};

}  // namespace asos::gltf
