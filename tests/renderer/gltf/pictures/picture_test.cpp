#include "renderer/gltf/pictures/picture.h"

#include "renderer/film/image_io.h"
#include "renderer/gltf/pictures/row_means.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <jpeglib.h>
#include <random>
#include <string>
#include <vector>
#include <webp/encode.h>

namespace asos::picture_test {
namespace {

using File = std::vector<std::uint8_t>;

/// Something else in every texel, the same each time.
Image speckled(int width, int height) {
  std::mt19937 random(7);
  return test::make_image(width, height, [&](int, int) {
    const auto any = [&] { return static_cast<std::uint8_t>(random()); };
    // Encoders of WebP change the colours of what is wholly transparent.
    return test::Texel{any(), any(), any(), static_cast<std::uint8_t>(any() | 1)};
  });
}

/// The means by the book.
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

/// Without its alpha, which JPEG and the PNGs of write_png have not.
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

/// Smooth, so that a JPEG of it is close to it.
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
      for (int y = 0; y < height; ++y)
        means.add({image.rgba.data() + std::ptrdiff_t{4} * width * y,
                   4 * static_cast<std::size_t>(width)});
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
      // The slope goes on beyond the border in the decoder's own means.
      expect_same(jpeg->image, reduced(smooth, shrink), shrink > 1 ? 2 * shrink : 4);
    }
  }
  const auto small = read_picture(webp_of(smooth), 4);
  ASSERT_TRUE(small) << small.error();
  expect_same(small->image, reduced(smooth, 4), 3);
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
  // Wrong sums are no reason not to show it.
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

TEST(Pictures, OfOtherFormatsAreNamed) {
  const auto reason = [](const std::string& text) {
    const auto picture = read_picture(File(text.begin(), text.end()));
    return picture ? "" : picture.error();
  };
  EXPECT_EQ(reason(""), "it is empty");
  EXPECT_EQ(reason("GIF89a"), "GIF pictures are not supported");
  EXPECT_EQ(reason("DDS ...."), "DDS pictures are not supported");
  EXPECT_EQ(reason("nothing"), "it is no usable PNG, JPEG or WebP");
}

}  // namespace
}  // namespace asos::picture_test
