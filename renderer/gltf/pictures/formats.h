#pragma once

#include "renderer/gltf/pictures/picture.h"

// One reader per format; is_png is in renderer/film/image_text.h. Each gets bytes that begin like
// its format; `head` is the result of its `..._head`. None prints, or lets an exception or a
// library's jump escape.

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

/// Whether the bytes are a TGA or a BMP, which old models have.
[[nodiscard]] bool is_bitmap(PictureBytes bytes);
[[nodiscard]] PictureResult<PictureHead> bitmap_head(PictureBytes bytes);
[[nodiscard]] PictureResult<Picture> read_bitmap_picture(PictureBytes bytes,
                                                         const PictureHead& head, int shrink);

}  // namespace asos
