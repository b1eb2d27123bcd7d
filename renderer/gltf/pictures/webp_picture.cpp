#include "renderer/gltf/pictures/formats.h"

#include <cstring>
#include <utility>
#include <webp/decode.h>

namespace asos {
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

bool is_webp(PictureBytes bytes) {
  return bytes.size() >= 12 && std::memcmp(bytes.data(), "RIFF", 4) == 0 &&
         std::memcmp(bytes.data() + 8, "WEBP", 4) == 0;
}

PictureResult<PictureHead> webp_head(PictureBytes bytes) {
  constexpr int lossless = 2;
  WebPBitstreamFeatures features;
  const VP8StatusCode known = WebPGetFeatures(bytes.data(), bytes.size(), &features);
  if (known != VP8_STATUS_OK)
    return tl::unexpected<std::string>(std::string("it is no usable WebP picture: ") +
                                       reason_of(known));
  if (features.has_animation != 0)
    return tl::unexpected<std::string>("animated WebP pictures are not supported");
  PictureHead head{features.width, features.height, 0};
  // In lossy pictures, only the alpha channel is held until the end.
  if (features.format == lossless) head.held_bytes = 4 * head.pixels();
  if (features.format != lossless && features.has_alpha != 0) head.held_bytes = 2 * head.pixels();
  return head;
}

PictureResult<Picture> read_webp_picture(PictureBytes bytes, const PictureHead& head, int shrink) {
  WebPDecoderConfig config;
  if (WebPInitDecoderConfig(&config) == 0)
    return tl::unexpected<std::string>("it is of another version than libwebp");
  Picture picture;
  picture.image.width = shrunk(head.width, shrink);
  picture.image.height = shrunk(head.height, shrink);
  SharedBytes::Bytes rgba(4 * static_cast<std::size_t>(picture.image.width) *
                          static_cast<std::size_t>(picture.image.height));
  config.options.use_scaling = shrink > 1 ? 1 : 0;
  config.options.scaled_width = picture.image.width;
  config.options.scaled_height = picture.image.height;
  config.output.colorspace = MODE_RGBA;
  config.output.is_external_memory = 1;
  config.output.u.RGBA = {rgba.data(), 4 * picture.image.width, rgba.size()};
  const VP8StatusCode done = WebPDecode(bytes.data(), bytes.size(), &config);
  WebPFreeDecBuffer(&config.output);
  if (done != VP8_STATUS_OK)
    return tl::unexpected<std::string>(std::string("it cannot be decoded: WebP data, and ") +
                                       reason_of(done));
  picture.image.rgba = std::move(rgba);
  return picture;
}

}  // namespace asos
