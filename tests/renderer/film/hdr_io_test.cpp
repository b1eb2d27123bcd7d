#include "renderer/film/hdr_io.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace asos::hdr_io_test {
namespace {

std::string head(int width, int height) {
  return "#?RADIANCE\n# a remark\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n-Y " +
         std::to_string(height) + " +X " + std::to_string(width) + "\n";
}

class HdrFile : public testing::Test {
 protected:
  [[nodiscard]] Result<HdrImage> read(const std::string& bytes, const SizeCheck& check = {}) const {
    return read_hdr(folder_.write("picture.hdr", bytes), check);
  }
  [[nodiscard]] std::string refusal(const std::string& bytes) const {
    const auto image = read(bytes);
    return image ? "" : image.error().reason;
  }

  test::TemporaryFolder folder_;
};

/// A run-length encoded row: its header, then the given bytes of four channels.
std::string packed(int width, const std::vector<std::string>& channels) {
  std::string row{'\x02', '\x02', static_cast<char>(width >> 8), static_cast<char>(width & 255)};
  for (const std::string& channel : channels) row += channel;
  return row;
}

TEST_F(HdrFile, PackedRowsHoldRunsAndWhatIsNone) {
  // Ten pixels per channel: a run of 10 of 128; single values; runs of 4 and 6; a run of 10.
  const std::string bytes =
      head(10, 1) + packed(10, {"\x8a\x80", "\x0a\x01\x02\x03\x04\x05\x06\x07\x08\x09\x0a",
                                "\x84\x08\x06\x01\x01\x01\x01\x01\x40", "\x8a\x88"});
  const auto image = read(bytes);
  ASSERT_TRUE(image) << image.error().message();
  ASSERT_EQ(image->pixels.size(), 10u);
  // With the exponent 136 a value equals its mantissa.
  for (std::size_t x = 0; x < 10; ++x) {
    EXPECT_EQ(radiance_of(image->pixels[x]).r, 128.0f);
    EXPECT_EQ(radiance_of(image->pixels[x]).g, static_cast<float>(x + 1));
    EXPECT_EQ(radiance_of(image->pixels[x]).b, x < 4 ? 8.0f : x < 9 ? 1.0f : 64.0f);
  }
}

TEST_F(HdrFile, FlatRowsAreReadAndMayRepeatPixels) {
  using std::string_literals::operator""s;
  const auto plain = read(head(2, 2) + "\x80\x40\x20\x81"s + "\x80\x40\x20\x82"s +
                          "\x01\x02\x03\x88"s + "\x00\x00\x00\x00"s);
  ASSERT_TRUE(plain) << plain.error().message();
  EXPECT_EQ(radiance_of(plain->pixels[0]), glm::vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(radiance_of(plain->pixels[1]), glm::vec3(2, 1, 0.5f));
  EXPECT_EQ(radiance_of(plain->pixels[2]), glm::vec3(1, 2, 3));
  EXPECT_EQ(radiance_of(plain->pixels[3]), glm::vec3(0));
  const auto repeated =
      read(head(300, 1) + "\x80\x40\x20\x81"s + "\x01\x01\x01\x2b"s + "\x01\x01\x01\x01"s);
  ASSERT_TRUE(repeated) << repeated.error().message();
  EXPECT_EQ(radiance_of(repeated->pixels[299]), glm::vec3(1, 0.5f, 0.25f));
}

TEST_F(HdrFile, RunsThatDoNotEndAreRefused) {
  using std::string_literals::operator""s;
  // A run length of 0 would make a naive reader loop for ever.
  const std::string row = packed(8, {});
  EXPECT_NE(refusal(head(8, 1) + row + std::string(64, '\0')).find("row 0"), std::string::npos);
  EXPECT_NE(refusal(head(8, 1) + row + "\x80"s).find("row 0"), std::string::npos);
  EXPECT_NE(refusal(head(8, 1) + row + "\x89\x01"s).find("row 0"), std::string::npos);
  EXPECT_NE(refusal(head(4, 1) + "\x01\x01\x01\x00"s + "\x01\x01\x01\x00"s).find("row 0"),
            std::string::npos);
  EXPECT_NE(refusal(head(8, 1'000'000)).find("ends too early"), std::string::npos);
}

TEST_F(HdrFile, HeadersOfAnotherKindAreRefusedByName) {
  EXPECT_EQ(refusal(""), "is not a Radiance picture");
  EXPECT_EQ(refusal("\x89PNG"), "is not a Radiance picture");
  EXPECT_NE(refusal("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n    ").find("xyze"),
            std::string::npos);
  EXPECT_NE(refusal("#?RADIANCE\n\n+Y 1 +X 1\n    ").find("+Y 1 +X 1"), std::string::npos);
  EXPECT_NE(refusal("#?RADIANCE\n\n-Y 99999999999999999999 +X 1\n").find("none that is read"),
            std::string::npos);
  EXPECT_NE(refusal("#?RADIANCE\n\n-Y 0 +X 1\n").find("0 pixels"), std::string::npos);
  EXPECT_NE(refusal("#?RADIANCE\n" + std::string(1 << 20, 'x')).find("header"), std::string::npos);
}

TEST_F(HdrFile, TheSizeIsAskedAboutBeforeThePicture) {
  const auto check = [](std::int64_t width, std::int64_t height) {
    return std::to_string(width) + " by " + std::to_string(height);
  };
  const auto image = read(head(7, 3), check);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().reason, "7 by 3");
}

TEST_F(HdrFile, SoManyPixelsInSoFewBytesAreRefused) {
  // Rows without any bytes would fail earlier.
  const std::string rows(4 * 5792, '\0');
  EXPECT_NE(refusal(head(11584, 5792) + rows).find("has 11584 x 5792 pixels in "),
            std::string::npos);
  EXPECT_NE(refusal(head(8192, 4096) + rows).find("row 0 is damaged"), std::string::npos)
      << "accepted for any file size";
}

TEST_F(HdrFile, WhatPixelsWereMultipliedByIsUndone) {
  const auto with = [](const std::string& lines) {
    return "#?RADIANCE\n" + lines + "FORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x40\x20\x81";
  };
  const auto scale = [&](const std::string& lines) {
    const auto image = read(with(lines));
    return image ? image->scale : glm::vec3(0.0f);
  };
  EXPECT_EQ(scale(""), glm::vec3(1.0f));
  // All EXPOSURE lines multiply, and so do those of single channels.
  EXPECT_EQ(scale("EXPOSURE=4\nEXPOSURE= 5.0e-1\n"), glm::vec3(0.5f));
  EXPECT_EQ(scale("COLORCORR= 2 4 0.5\nEXPOSURE=2\r\n"), glm::vec3(0.25f, 0.125f, 1.0f));
  for (const char* line :
       {"EXPOSURE=", "EXPOSURE=0", "EXPOSURE=-1", "EXPOSURE=nan", "EXPOSURE=inf", "EXPOSURE=1 2",
        "EXPOSURE=1e999", "COLORCORR=1 1", "COLORCORR=1 0 1", "COLORCORR=1 1 1 1"}) {
    EXPECT_NE(refusal(with(std::string(line) + "\n")).find(line), std::string::npos) << line;
  }
  EXPECT_NE(refusal(with("EXPOSURE=1e-30\nEXPOSURE=1e-30\n")).find("multiply to what no number"),
            std::string::npos);
}

TEST_F(HdrFile, BrokenAnywhereItIsReadOrRefused) {
  const std::string good =
      head(10, 2) + packed(10, {"\x8a\x80", "\x8a\x40", "\x84\x08\x86\x09", "\x8a\x88"}) +
      packed(10,
             {"\x0a\x01\x02\x03\x04\x05\x06\x07\x08\x09\x0a", "\x8a\x40", "\x8a\x08", "\x8a\x88"});
  ASSERT_TRUE(read(good));
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    std::string broken = good;
    for (int k = 0; k < 1 + i % 3; ++k)
      broken[random() % broken.size()] = static_cast<char>(random() % 256);
    if (i % 4 == 0) broken.resize(random() % broken.size());
    if (const auto image = read(broken)) {
      EXPECT_EQ(image->pixels.size(),
                static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height));
    }
  }
}

}  // namespace
}  // namespace asos::hdr_io_test
