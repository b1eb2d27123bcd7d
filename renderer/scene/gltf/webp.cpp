#include "renderer/scene/gltf/webp.h"

#include "renderer/scene/gltf/image_limits.h"

#include <cstring>
#include <utility>
#include <webp/decode.h>

namespace asos::gltf {

namespace {

const char* reason_of(VP8StatusCode status) {
  switch (status) {
    case VP8_STATUS_OUT_OF_MEMORY:
      return "it needs too much memory";
    case VP8_STATUS_UNSUPPORTED_FEATURE:
      return "it uses what is not supported";
    case VP8_STATUS_NOT_ENOUGH_DATA:
      return "it is cut off";
    default:
      return "its data is broken";
  }
}

}  // namespace

bool is_webp(Bytes bytes) {
  return bytes.size() >= 12 && std::memcmp(bytes.data(), "RIFF", 4) == 0 &&
         std::memcmp(bytes.data() + 8, "WEBP", 4) == 0;
}

Checked<Image> decode_webp(Bytes bytes, std::uint64_t most_pixels) {
  WebPBitstreamFeatures features;
  const VP8StatusCode known = WebPGetFeatures(bytes.data(), bytes.size(), &features);
  if (known != VP8_STATUS_OK)
    return fault(std::string("it is no usable WebP picture: ") + reason_of(known));
  if (features.has_animation != 0) return fault("animated WebP pictures are not supported");
  if (auto sound = check_size(features.width, features.height, bytes.size(), most_pixels); !sound)
    return fault(sound.error());

  Image image;
  image.width = features.width;
  image.height = features.height;
  SharedBytes::Bytes rgba(4 * static_cast<std::size_t>(image.width) *
                          static_cast<std::size_t>(image.height));
  if (!WebPDecodeRGBAInto(bytes.data(), bytes.size(), rgba.data(), rgba.size(), 4 * image.width))
    return fault("it cannot be decoded (WebP data that is broken or cut off)");
  image.rgba = std::move(rgba);
  return image;
}

}  // namespace asos::gltf
