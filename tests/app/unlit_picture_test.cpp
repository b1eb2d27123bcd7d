#include "renderer/film/image_io.h"
#include "tests/app/run_asos.h"
#include "tests/support/shared_dir.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace asos {
namespace {

// KHR_materials_unlit colours are displayed unchanged. Strips of 10 pixels.
TEST(UnlitPicture, ShowsTheBytesOfItsTexture) {
  const auto shared = test::shared_dir();
  if (!shared) GTEST_SKIP() << "no shared folder; set ASOS_SHARED";
  const auto file = *shared / "reported" / "unlit-is-tone-mapped_colour-chart.glb";
  if (!exists(file)) GTEST_SKIP() << "there is no " << file;
  constexpr std::array<std::array<int, 3>, 15> strips{{{0, 0, 0},
                                                       {32, 32, 32},
                                                       {64, 64, 64},
                                                       {128, 128, 128},
                                                       {188, 188, 188},
                                                       {220, 220, 220},
                                                       {240, 240, 240},
                                                       {255, 255, 255},
                                                       {255, 0, 0},
                                                       {0, 255, 0},
                                                       {0, 0, 255},
                                                       {255, 255, 0},
                                                       {0, 255, 255},
                                                       {255, 0, 255},
                                                       {255, 128, 0}}};
  const test::TemporaryFolder folder;
  const std::string to = folder.file("chart.png");
  const std::vector<std::vector<std::string>> choices{
      {}, {"--exposure", "2", "--tone", "agx"}, {"--method", "sobol", "--spp", "4"}};
  for (const auto& options : choices) {
    const auto run = test::run_asos(
        std::vector<std::string>{"render", file.string(), "-o", to, "--size", "160x90"} + options);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const RgbImage png = read_png(to).value();
    for (std::size_t strip = 0; strip < strips.size(); ++strip)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(png.rgb[3 * (45 * 160 + 10 * strip + 5) + c], strips[strip][c], 1)
            << "strip " << strip;
  }
}

}  // namespace
}  // namespace asos
