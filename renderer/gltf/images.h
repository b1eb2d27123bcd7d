#pragma once

#include "renderer/gltf/accessors.h"
#include "renderer/gltf/pictures/picture.h"
#include "renderer/scene/scene.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace asos::gltf {

/// The bytes of one of the document's images; `read` owns them if they are not part of a buffer.
struct ImageBytes {
  FileBytes read;
  Bytes bytes;
  std::string remark;  ///< see UriBytes
};
/// Returns an image's bytes. Fault: there are none.
[[nodiscard]] Checked<ImageBytes> image_bytes(Document& document, Accessors& accessors, int index);

/// Imports a document's textures when materials need them, so that unused images are neither
/// decoded nor stored. If all images together exceed the budget of the file, the largest are
/// reduced while reading, with a warning (texture_budget.h).
class Textures {
 public:
  Textures(Document& document, Accessors& accessors, Scene& scene);

  /// Decodes images on all processors, before the first use of one. `read` uses the textures that
  /// will be used later; meanwhile, this object only notes which ones. Gives no warnings.
  template <typename Read>
  void decode_ahead(const Read& read) {
    if (std::exchange(decoded_ahead_, true)) return;
    noting_ = true;
    read();
    noting_ = false;
    decode_noted();
  }

  /// Returns the scene's texture for one of the document's. Returns -1, with a warning, if it has
  /// no usable image: the material is then drawn without it.
  [[nodiscard]] int use(int texture);

  /// Returns a texture with the roughness 1 - factor * alpha of one of the scene's textures in
  /// green (KHR_materials_pbrSpecularGlossiness); `factor` is 0 to 1. Each factor takes the image's
  /// memory again: returns -1, with a warning, for too many factors of one image, or if all copies
  /// are too large for the file's size.
  [[nodiscard]] int roughness_of(int texture, float factor);

 private:
  /// Bytes of a buffer, or a file: images with the same place are one.
  using ImagePlace = std::tuple<const std::uint8_t*, std::size_t, std::string>;
  struct DecodedImage {
    std::string remark;  ///< see UriBytes
    PictureResult<Picture> picture;
  };

  [[nodiscard]] int load(int texture);
  [[nodiscard]] int image_of(const tinygltf::Texture& texture, int index);
  [[nodiscard]] int use_image(int image);
  [[nodiscard]] Checked<int> add_image(int image);
  [[nodiscard]] Checked<DecodedImage> take_decoded(int image);
  [[nodiscard]] Checked<ImageBytes> take_bytes(int image);
  [[nodiscard]] int note(int texture);
  /// Returns the document's image of a texture; -1: none.
  [[nodiscard]] int image_named(int texture) const;
  void leave_out_images();
  void decode_noted();
  [[nodiscard]] ImagePlace place_of(const ImageSource& source);
  void plan();
  [[nodiscard]] std::string name_of(int image) const;

  Document& doc_;
  Accessors& accessors_;
  Scene& scene_;
  std::vector<int> texture_of_;  // by document texture: the scene's texture, or unknown
  std::vector<int> image_of_;
  std::map<ImagePlace, int> image_at_;  // the scene's image, by the place of its bytes
  std::vector<int> shrinks_;            // by document image; empty before plan()
  std::vector<std::uint64_t> pixels_;   // by document image; 0: it is no picture, or a copy
  std::map<int, std::uint32_t> later_;  // document images that are left out, and their texel
  std::map<int, ImageBytes> read_;      // by document image: files read for the plan
  std::set<int> noted_;                 // document images
  bool noting_ = false, decoded_ahead_ = false;
  std::map<int, DecodedImage> decoded_;  // by document image: those decoded ahead
  std::uint64_t all_bytes_ = 0;          // of encoded images
  std::uint64_t copied_texels_ = 0;      // by `roughness_of`
  std::map<int, std::vector<std::pair<float, int>>> roughness_of_;  // by image: factor, image
};

}  // namespace asos::gltf
