#pragma once

#include "renderer/gltf/pictures/picture.h"

// One reader a format; is_png is that of renderer/film/image_text.h. Each is given bytes that begin
// as its pictures do; `head` is what its
// `..._head` has said of them. None prints or lets an exception or a jump of its library out.

namespace asos {

[[nodiscard]] PictureResult<PictureHead> png_head(PictureBytes bytes);
[[nodiscard]] PictureResult<Picture> read_png_picture(PictureBytes bytes, const PictureHead& head,
                                                      int shrink);

[[nodiscard]] bool is_jpeg(PictureBytes bytes);
[[nodiscard]] PictureResult<PictureHead> jpeg_head(PictureBytes bytes);
[[nodiscard]] PictureResult<Picture> read_jpeg_picture(PictureBytes bytes, const PictureHead& head,
                                                       int shrink);

[[nodiscard]] bool is_webp(PictureBytes bytes);
[[nodiscard]] PictureResult<PictureHead> webp_head(PictureBytes bytes);
[[nodiscard]] PictureResult<Picture> read_webp_picture(PictureBytes bytes, const PictureHead& head,
                                                       int shrink);

}  // namespace asos
