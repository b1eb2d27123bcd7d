#include "renderer/gltf/pictures/picture.h"

#include "renderer/film/image_io.h"
#include "renderer/gltf/pictures/row_means.h"
#include "renderer/shading/mip_levels.h"
#include "renderer/shading/texture.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <jpeglib.h>
#include <png.h>
#include <random>
#include <string>
#include <vector>
#include <webp/encode.h>

namespace asos::picture_test {
namespace {

using File = std::vector<std::uint8_t>;

/// Random texels, the same in every run.
Image speckled(int width, int height) {
  std::mt19937 random(7);
  return test::make_image(width, height, [&](int, int) {
    const auto any = [&] { return static_cast<std::uint8_t>(random()); };
    // Encoders of WebP change the colours of fully transparent texels.
    return test::Texel{any(), any(), any(), static_cast<std::uint8_t>(any() | 1)};
  });
}

/// Reference: means over shrink x shrink texels.
Image reduced(const Image& image, int shrink) {
  return test::make_image(
      shrunk(image.width, shrink), shrunk(image.height, shrink), [&](int x, int y) {
        test::Texel texel{};
        for (std::size_t c = 0; c < 4; ++c) {
          double sum = 0.0;
          int count = 0;
          for (int v = y * shrink; v < std::min((y + 1) * shrink, image.height); ++v)
            for (int u = x * shrink; u < std::min((x + 1) * shrink, image.width); ++u, ++count)
              sum += image.rgba[4 * static_cast<std::size_t>(v * image.width + u) + c];
          texel[c] = static_cast<std::uint8_t>(std::floor(sum / count + 0.5));
        }
        return texel;
      });
}

void expect_same(const Image& a, const Image& b, int tolerance = 0) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    ASSERT_LE(std::abs(int{a.rgba[i]} - int{b.rgba[i]}), tolerance) << i;
}

/// The image without alpha, which JPEG and the PNGs of write_png lack.
Image opaque(Image image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba.own()[i] = 255;
  return image;
}

File png_of(const Image& image) {
  RgbImage rgb{image.width, image.height, {}, {}};
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 != 3) rgb.rgb.push_back(image.rgba[i]);
  const test::TemporaryFolder folder;
  EXPECT_TRUE(write_png(folder.file("a.png"), rgb));
  const std::string bytes = test::content_of(folder.file("a.png"));
  return {bytes.begin(), bytes.end()};
}

File webp_of(const Image& image) {
  std::uint8_t* made = nullptr;
  const std::size_t size =
      WebPEncodeLosslessRGBA(image.rgba.data(), image.width, image.height, 4 * image.width, &made);
  File file(made, made + size);
  WebPFree(made);
  return file;
}

File jpeg_of(const Image& image, bool progressive) {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* made = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &made, &size);
  info.image_width = static_cast<unsigned>(image.width);
  info.image_height = static_cast<unsigned>(image.height);
  info.input_components = 4;
  info.in_color_space = JCS_EXT_RGBA;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 98, TRUE);
  if (progressive) jpeg_simple_progression(&info);
  jpeg_start_compress(&info, TRUE);
  for (int y = 0; y < image.height; ++y) {
    std::vector<std::uint8_t> row(image.rgba.data() + std::ptrdiff_t{4} * image.width * y,
                                  image.rgba.data() + std::ptrdiff_t{4} * image.width * (y + 1));
    JSAMPROW at = row.data();
    jpeg_write_scanlines(&info, &at, 1);
  }
  jpeg_finish_compress(&info);
  File file(made, made + size);
  jpeg_destroy_compress(&info);
  std::free(made);
  return file;
}

/// A smooth image, which JPEG reproduces well.
Image slope(int width, int height) {
  return test::make_image(width, height, [](int x, int y) {
    return test::Texel{static_cast<std::uint8_t>(2 * x), static_cast<std::uint8_t>(2 * y),
                       static_cast<std::uint8_t>(x + y), 255};
  });
}

std::size_t last_marker(const File& file, std::uint8_t marker) {
  for (std::size_t i = file.size() - 1; i > 0; --i)
    if (file[i - 1] == 0xff && file[i] == marker) return i - 1;
  return file.size();
}

TEST(RowMeans, AreTheMeansOfTheirPixels) {
  for (const auto& [width, height] : {std::pair{1, 1}, {5, 3}, {8, 8}, {13, 17}}) {
    const Image image = speckled(width, height);
    for (const int shrink : {1, 2, 4, 64}) {
      RowMeans means(width, height, shrink);
      for (int y = 0; y < height; ++y) {
        const std::span<std::uint8_t> row = means.next();
        ASSERT_EQ(row.size(), 4 * static_cast<std::size_t>(width));
        std::copy_n(image.rgba.data() + row.size() * static_cast<std::size_t>(y), row.size(),
                    row.begin());
        means.add();
      }
      expect_same(means.take(), reduced(image, shrink));
    }
  }
}

TEST(Pictures, ArriveAsTheyAreOrReduced) {
  const Image image = opaque(speckled(37, 21));
  for (const int shrink : {1, 2, 8}) {
    const auto png = read_picture(png_of(image), shrink);
    ASSERT_TRUE(png) << png.error();
    expect_same(png->image, reduced(image, shrink));
    EXPECT_EQ(png->remark, "");
  }
  const Image clear = speckled(37, 21);
  const auto webp = read_picture(webp_of(clear));
  ASSERT_TRUE(webp) << webp.error();
  expect_same(webp->image, clear);
  const Image smooth = slope(100, 60);
  for (const bool progressive : {false, true}) {
    for (const int shrink : {1, 2, 8, 16}) {
      const auto jpeg = read_picture(jpeg_of(smooth, progressive), shrink);
      ASSERT_TRUE(jpeg) << jpeg.error();
      // The decoder's own averages extrapolate the slope beyond the border.
      expect_same(jpeg->image, reduced(smooth, shrink), shrink > 1 ? 2 * shrink : 4);
    }
  }
  const auto small = read_picture(webp_of(smooth), 4);
  ASSERT_TRUE(small) << small.error();
  expect_same(small->image, reduced(smooth, 4), 3);
}

/// A PNG with 16 bits per value; `values` are RGBA, or grey if there is one per pixel.
File wide_png(int width, int height, const std::vector<std::uint16_t>& values, bool interlaced) {
  File file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &file,
      [](png_structp writer, png_bytep bytes, std::size_t count) {
        auto& to = *static_cast<File*>(png_get_io_ptr(writer));
        to.insert(to.end(), bytes, bytes + count);
      },
      nullptr);
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const bool grey = values.size() == pixels;
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 16,
               grey ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB_ALPHA,
               interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  File bytes;
  for (const std::uint16_t value : values) {
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
    bytes.push_back(static_cast<std::uint8_t>(value & 255));
  }
  std::vector<png_bytep> rows;
  const std::size_t row = bytes.size() / static_cast<std::size_t>(height);
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
    rows.push_back(&bytes[y * row]);
  png_write_image(png, rows.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return file;
}

TEST(Pictures, PngsOfSixteenBitsKeepThem) {
  std::mt19937 random(5);
  std::vector<std::uint16_t> values(4 * 9 * 5);
  for (std::uint16_t& value : values) value = static_cast<std::uint16_t>(random());
  for (const bool interlaced : {false, true}) {
    const PictureResult<Picture> picture = read_picture(wide_png(9, 5, values, interlaced));
    ASSERT_TRUE(picture) << picture.error();
    World world;
    world.images.push_back(picture->image);
    world.textures.emplace_back();
    world.textures[0].image = 0;
    world.textures[0].filter = Filter::nearest;
    for (std::size_t i = 0; i < values.size() / 4; ++i) {
      const glm::vec2 uv((static_cast<float>(i % 9) + 0.5f) / 9.0f,
                         (static_cast<float>(i / 9) + 0.5f) / 5.0f);
      const glm::vec4 linear = sample_texture(world, 0, uv, Encoding::linear);
      const glm::vec4 srgb = sample_texture(world, 0, uv, Encoding::srgb);
      for (int c = 0; c < 4; ++c) {
        const double right = values[4 * i + static_cast<std::size_t>(c)] / 65535.0;
        EXPECT_NEAR(linear[c], right, 1e-7);
        const double decoded =
            right <= 0.04045 ? right / 12.92 : std::pow((right + 0.055) / 1.055, 2.4);
        EXPECT_NEAR(srgb[c], c == 3 ? right : decoded, 1e-7);
      }
    }
    // Averages keep the precision, too.
    const std::vector<MipLevel> chain = make_mip_levels(picture->image, TexelKind::data);
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); i += 4) sum += values[i] / 65535.0;
    EXPECT_NEAR(chain.back().at(0, 0).r, sum / 45.0, 2e-4);
  }
}

TEST(Pictures, PngsOfSixteenBitsThatSayNoMoreThanEightTakeNoMore) {
  std::vector<std::uint16_t> grey(16);
  for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = static_cast<std::uint16_t>(257 * 16 * i);
  const PictureResult<Picture> picture = read_picture(wide_png(4, 4, grey, false));
  ASSERT_TRUE(picture) << picture.error();
  EXPECT_TRUE(picture->image.low.empty());
  for (std::size_t i = 0; i < grey.size(); ++i) {
    EXPECT_EQ(picture->image.rgba[4 * i], 16 * i);
    EXPECT_EQ(picture->image.rgba[4 * i + 3], 255);
  }
  grey[3] += 1;
  const PictureResult<Picture> more = read_picture(wide_png(4, 4, grey, false));
  ASSERT_TRUE(more) << more.error();
  EXPECT_EQ(more->image.low.size(), more->image.rgba.size());
  EXPECT_EQ(more->image.low[4 * 3 + 3], 255) << "opaque";
}

TEST(Pictures, OfDamagedDataAreRefusedOrRemarkedOn) {
  const Image image = slope(64, 64);
  const File jpeg = jpeg_of(image, false);
  const auto half = read_picture(std::span(jpeg).first(jpeg.size() / 2));
  ASSERT_TRUE(half) << half.error();
  EXPECT_NE(half->remark.find("its data is damaged (Premature end of JPEG file)"),
            std::string::npos)
      << half->remark;
  for (const File& file : {png_of(image), webp_of(image)}) {
    const auto cut = read_picture(std::span(file).first(file.size() / 2));
    ASSERT_FALSE(cut);
    EXPECT_FALSE(cut.error().empty());
  }
  // Images with wrong checksums are still shown.
  File png = png_of(image);
  png[png.size() - 13] ^= 1;
  EXPECT_TRUE(read_picture(png));
}

TEST(Pictures, AJpegOfThousandsOfScansIsGivenUp) {
  File jpeg = jpeg_of(slope(64, 64), true);
  const std::size_t scan = last_marker(jpeg, 0xda), end = last_marker(jpeg, 0xd9);
  ASSERT_LT(scan, end);
  const File again(jpeg.begin() + static_cast<std::ptrdiff_t>(scan),
                   jpeg.begin() + static_cast<std::ptrdiff_t>(end));
  for (int i = 0; i < 250; ++i)
    jpeg.insert(jpeg.begin() + static_cast<std::ptrdiff_t>(end), again.begin(), again.end());
  const auto picture = read_picture(jpeg);
  ASSERT_FALSE(picture);
  EXPECT_NE(picture.error().find("more than 200 scans"), std::string::npos) << picture.error();
}

TEST(Pictures, WhatTheirDecoderHoldsIsBounded) {
  File jpeg = jpeg_of(slope(64, 64), true);
  const std::size_t head = last_marker(jpeg, 0xc2);  // length, bits, height, width
  ASSERT_LT(head, jpeg.size());
  for (const std::size_t at : {head + 5, head + 7}) {
    jpeg[at] = 16'000 >> 8;
    jpeg[at + 1] = 16'000 & 255;
  }
  jpeg.resize(400'000);
  const auto held = picture_head(jpeg);
  ASSERT_TRUE(held) << held.error();
  EXPECT_GE(held->held_bytes, std::uint64_t{700'000'000});
  const auto picture = read_picture(jpeg, 8);
  ASSERT_FALSE(picture);
  EXPECT_NE(picture.error().find("takes more memory"), std::string::npos) << picture.error();
  EXPECT_EQ(picture_head(jpeg_of(slope(64, 64), false))->held_bytes, 0u);
}

// A TGA of 2 x 2 pixels, bottom row first: blue, green; red, white.
File small_tga(int type) {
  File tga{0, 0, static_cast<std::uint8_t>(type), 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0};
  for (const int value : {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255})
    tga.push_back(static_cast<std::uint8_t>(value));
  return tga;
}

TEST(Pictures, OfOldFormatsAreReadAndReduced) {
  const auto whole = read_picture(small_tga(2));
  ASSERT_TRUE(whole) << whole.error();
  EXPECT_EQ(whole->image.rgba.get(), (SharedBytes::Bytes{255, 0, 0, 255, 255, 255, 255, 255,  //
                                                         0, 0, 255, 255, 0, 255, 0, 255}));
  const auto reduced = read_picture(small_tga(2), 2);
  ASSERT_TRUE(reduced) << reduced.error();
  EXPECT_EQ(reduced->image.width, 1);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(reduced->image.rgba.get()[c], 128, 1);
  File cut = small_tga(2);
  cut.resize(20);
  EXPECT_FALSE(read_picture(cut));
  // Packed, a few bytes can claim any size.
  File large = small_tga(10);
  large[13] = large[15] = 16'000 >> 8;
  large.resize(400'000);
  const auto refused = read_picture(large, 8);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("takes more memory"), std::string::npos) << refused.error();
}

TEST(Pictures, OfOtherFormatsAreNamed) {
  const auto reason = [](const std::string& text) {
    const auto picture = read_picture(File(text.begin(), text.end()));
    return picture ? "" : picture.error();
  };
  EXPECT_EQ(reason(""), "it is empty");
  EXPECT_EQ(reason("GIF89a"), "GIF pictures are not supported");
  EXPECT_EQ(reason("DDS ...."), "DDS pictures are not supported");
  EXPECT_EQ(reason("nothing"), "it is no usable PNG, JPEG, WebP, TGA or BMP");
}

}  // namespace
}  // namespace asos::picture_test
