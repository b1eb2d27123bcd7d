#include "renderer/film/image_io.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/sky.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asos {
namespace {

class SkyFile : public testing::Test {
 protected:
  /// An EXR of one value except for one pixel.
  [[nodiscard]] std::string exr_with(const std::string& name, glm::vec3 odd) const {
    Film film(8, 4);
    film.radiance.assign(32, glm::vec3(0.25f));
    film.radiance[11] = odd;
    EXPECT_TRUE(write_exr(path(name), film, {}));
    return path(name);
  }
  [[nodiscard]] std::string write(const std::string& name, const std::string& bytes) const {
    return folder_.write(name, bytes);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }

 private:
  test::TemporaryFolder folder_;
};

std::string radiance_picture(int width, int height) {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) +
                      " +X " + std::to_string(width) + "\n";
  // Mantissas 128, 64, 32 of 256, times 2^(e - 128): rows of 2, 4, 8, ...
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) bytes += {'\x80', '\x40', '\x20', static_cast<char>(130 + y)};
  return bytes;
}

TEST_F(SkyFile, OfRadianceIsRead) {
  const auto sky = read_sky(write("a sky.hdr", radiance_picture(8, 4)));
  ASSERT_TRUE(sky) << sky.error().message();
  // The centre of the second row.
  const float s = std::sin(1.17809725f), c = std::cos(1.17809725f);
  const glm::vec3 seen = (*sky)->radiance({0.0f, c, -s});
  EXPECT_NEAR(seen.r, 4.0f, 1e-4f);
  EXPECT_NEAR(seen.g, 2.0f, 1e-4f);
  EXPECT_NEAR(seen.b, 1.0f, 1e-4f);
  EXPECT_EQ((*sky)->name(), path("a sky.hdr"));
}

TEST_F(SkyFile, OfExrIsRead) {
  const auto sky = read_sky(exr_with("sky.exr", {40000.0f, 1e8f, 3.0f}), 90.0);
  ASSERT_TRUE(sky) << sky.error().message();
  EXPECT_EQ((*sky)->radiance({0, 0.9f, 0.1f}).r, 0.25f);
  EXPECT_GT((*sky)->ambient({1, 0, 0}).g + (*sky)->ambient({-1, 0, 0}).g, 1e5f);
}

TEST_F(SkyFile, WithTexelsThatAreNoRadianceIsRefused) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const glm::vec3 odd : {glm::vec3(0, nan, 0), glm::vec3(infinity, 0, 0)}) {
    const auto sky = read_sky(exr_with("odd.exr", odd));
    ASSERT_FALSE(sky);
    EXPECT_EQ(sky.error().message(), path("odd.exr") +
                                         ": 1 of its 32 pixels are not finite and 0 are negative: "
                                         "no sky is");
  }
  const auto sky = read_sky(exr_with("odd.exr", {1, 1, -1e-6f}));
  ASSERT_FALSE(sky);
  EXPECT_NE(sky.error().message().find("0 of its 32 pixels are not finite and 1 are negative"),
            std::string::npos)
      << sky.error().message();
}

TEST_F(SkyFile, OfASingleRowLightsAllAlike) {
  Film film(2, 1);
  film.radiance = {{0.25f, 1.0f, 0.0f}, {0.75f, 1.0f, 0.0f}};
  ASSERT_TRUE(write_exr(path("row.exr"), film, {}));
  const auto sky = read_sky(path("row.exr"));
  ASSERT_TRUE(sky) << sky.error().message();
  for (const glm::vec3 normal : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(1, 0, 0)}) {
    const glm::vec3 light = (*sky)->ambient(normal);
    EXPECT_NEAR(light.r, 0.5f * sky_visibility, 1e-6f);
    EXPECT_NEAR(light.g, sky_visibility, 1e-6f);
    EXPECT_EQ(light.b, 0.0f);
  }
}

TEST_F(SkyFile, TooBrightToBeAddedUpIsRefused) {
  for (const float bright : {1.1e15f, 1e30f, 3.4e38f}) {
    const auto sky = read_sky(exr_with("bright.exr", {0.0f, bright, 0.0f}));
    ASSERT_FALSE(sky) << bright;
    EXPECT_EQ(sky.error().message(),
              path("bright.exr") + ": 1 of its 32 pixels are brighter than 1e+15: no sky is");
  }
  const auto sky = read_sky(exr_with("bright.exr", {0.0f, 9.9e14f, 0.0f}));
  ASSERT_TRUE(sky) << sky.error().message();
  const Sky brightest = (*sky)->brightened(SkyChoice::most_brightness);
  const float found = brightest.ambient({0, 1, 0}).g;
  EXPECT_TRUE(std::isfinite(found * found)) << found;
}

TEST_F(SkyFile, OfTheWrongKindIsRefused) {
  const std::string good = radiance_picture(8, 4);
  struct Case {
    std::string file;
    const char* reason;
  };
  const Case cases[] = {
      {path("missing.hdr"), "cannot be opened"},
      {path("missing.exr"), "cannot be opened"},
      {write("sky.png", good), "has to end in .hdr or .exr"},
      {write("empty.hdr", ""), "is not a Radiance picture"},
      {write("text.hdr", "a sky, blue"), "is not a Radiance picture"},
      {write("text.exr", "a sky, blue"), "is no EXR that can be read"},
      {write("square.hdr", radiance_picture(8, 8)), "has 8 x 8 pixels"},
      {write("huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 32768\n"),
       "at most 67108864"},
      {write("head.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4"), "cannot be read"},
  };
  for (const Case& c : cases) {
    const auto sky = read_sky(c.file);
    ASSERT_FALSE(sky) << c.file;
    const std::string message = sky.error().message();
    EXPECT_EQ(message.rfind(c.file, 0), 0u) << message;
    EXPECT_NE(message.find(c.reason), std::string::npos) << message;
  }
}

TEST_F(SkyFile, CutAnywhereIsReadOrRefused) {
  const std::string good = radiance_picture(8, 4);
  for (std::size_t length = 0; length < good.size(); ++length) {
    const auto sky = read_sky(write("cut.hdr", good.substr(0, length)));
    if (!sky) continue;
    const glm::vec3 up = (*sky)->ambient({0, 1, 0});
    EXPECT_TRUE(std::isfinite(up.r) && up.r >= 0.0f) << length;
  }
}

}  // namespace
}  // namespace asos
