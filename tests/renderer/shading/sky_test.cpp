#include "renderer/shading/sky.h"

#include "renderer/tasks.h"
#include "tests/renderer/shading/sky_sums.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace asos::test::sky_sums {
namespace {

TEST(Sky, OfOneColourIsThatEverywhere) {
  const glm::vec3 c(0.3f, 0.7f, 12.5f);
  std::vector<glm::vec3> texels(128 * 64, c);
  const Sky constant(c);
  const Sky map(SkyMap(128, 64, std::move(texels)), 33.0, "map");
  for (int i = 0; i < 64; ++i) {
    const Patch3 p = random_patch(i, i % 2 ? 0.05 : 1.0);
    EXPECT_EQ(constant.radiance(p.direction), c);
    EXPECT_EQ(constant.radiance(p.direction, p.right, p.down), c);
    EXPECT_EQ(constant.ambient(p.direction), sky_visibility * c);
    for (int k = 0; k < 3; ++k) {
      EXPECT_FLOAT_EQ(map.radiance(p.direction)[k], c[k]);
      EXPECT_FLOAT_EQ(map.radiance(p.direction, p.right, p.down)[k], c[k]);
      EXPECT_FLOAT_EQ(map.ambient(p.direction)[k], sky_visibility * c[k]);
    }
  }
}

// Waves along both axes, in the format of a Radiance image.
std::vector<Rgbe> waves(int height) {
  std::vector<Rgbe> texels;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < 2 * height; ++x) {
      const double u = (x + 0.5) / (2 * height), v = (y + 0.5) / height;
      const double wave = std::sin(8.0 * std::numbers::pi * u) * std::sin(4.0 * v);
      const auto byte = static_cast<std::uint8_t>(std::lround(150.0 + 100.0 * wave));
      texels.push_back({byte, 255, static_cast<std::uint8_t>(y % 251), 129});
    }
  }
  return texels;
}

TEST(SkyMap, TexelsOfARadiancePictureAreItsRadiance) {
  std::vector<glm::vec3> radiance;
  for (const Rgbe& pixel : waves(64)) radiance.push_back(radiance_of(pixel));
  const SkyMap plain(128, 64, std::move(radiance)), packed(128, 64, waves(64));
  const SkyLobes plain_lobes(plain), packed_lobes(packed);
  for (int i = 0; i < 256; ++i) {
    const Patch3 p = random_patch(i, 1.0);
    EXPECT_EQ(packed_lobes.irradiance_over_pi(p.direction),
              plain_lobes.irradiance_over_pi(p.direction));
    EXPECT_EQ(packed_lobes.around(p.direction, 0.7f), plain_lobes.around(p.direction, 0.7f));
    for (const double side : {0.0, 0.03, 0.1, 0.7})
      EXPECT_EQ(packed.mean(p.direction, side), plain.mean(p.direction, side)) << i << " " << side;
  }
}

TEST(Sky, ARadiancePicturesExposureIsUndone) {
  const test::TemporaryFolder folder;
  // Two pixels of radiance 1, 0.5 and 0.25, with EXPOSURE 4, and COLORCORR 2 for red.
  const std::string pixel = "\x80\x40\x20\x81";
  const auto sky = read_sky(folder.write("sky.hdr",
                                         "#?RADIANCE\nEXPOSURE=4\nCOLORCORR=2 1 1\n"
                                         "FORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" +
                                             pixel + pixel),
                            0.0);
  ASSERT_TRUE(sky) << sky.error().message();
  const glm::vec3 seen = (*sky)->radiance({0.0, 0.6, 0.8});
  EXPECT_NEAR(seen.r, 1.0f / 8.0f, 1e-6f);
  EXPECT_NEAR(seen.g, 0.5f / 4.0f, 1e-6f);
  EXPECT_NEAR(seen.b, 0.25f / 4.0f, 1e-6f);
}

TEST(SkyMap, ALargePictureTakesLittleMoreThanItsFile) {
  constexpr int height = 2048;
  const SkyMap large(2 * height, height, waves(height));
  const SkyMap small(height, height / 2, waves(height / 2));
  constexpr double texels = 2.0 * height * height;
  EXPECT_LT(static_cast<double>(large.memory_bytes()), 7.0 * texels);
  for (int i = 0; i < 512; ++i) {
    const Patch3 p = random_patch(i, 1.0);
    // One or two texels of the large image wide, which the small one resolves, too.
    for (const double texel : {0.5, 1.0, 2.0, 4.0}) {
      const double side = texel * std::numbers::sqrt3 * std::numbers::pi / height;
      const glm::vec3 a = large.mean(p.direction, side), b = small.mean(p.direction, side);
      EXPECT_NEAR(a.r, b.r, 0.02) << i << " " << texel;
      EXPECT_FLOAT_EQ(a.g, 255.0f / 128.0f) << i << " " << texel;
    }
  }
}

TEST(Sky, APictureIsSoManyTimesAsBrightAllOver) {
  const Sky dim(noise_map(32), 20.0, "noise");
  const Sky bright = dim.brightened(0.5).brightened(8.0);
  EXPECT_EQ(bright.name(), "noise, turned by 20 degrees, 8 times as bright");
  EXPECT_EQ(bright.choice().brightness, 8.0);
  for (int i = 0; i < 32; ++i) {
    const Patch3 p = random_patch(i, 0.3);
    EXPECT_EQ(bright.radiance(p.direction), 8.0f * dim.radiance(p.direction));
    EXPECT_EQ(bright.radiance(p.direction, p.right, p.down),
              8.0f * dim.radiance(p.direction, p.right, p.down));
    EXPECT_EQ(bright.around(p.direction, 0.4f), 8.0f * dim.around(p.direction, 0.4f));
    EXPECT_EQ(bright.ambient(p.direction), 8.0f * dim.ambient(p.direction));
    EXPECT_EQ(bright.bright_density(p.direction), dim.bright_density(p.direction));
  }
  const Sky colour(glm::vec3(0.5f));
  EXPECT_EQ(colour.brightened(8.0).radiance({0, 1, 0}), glm::vec3(0.5f)) << "no picture";
}

TEST(Sky, WithoutOneIsNeutral) {
  EXPECT_EQ(background(nullptr, {0, 0, -1}, nullptr, 1.0f), background_radiance);
  ViewedMaterial seen{};
  seen.ambient = glm::vec3(0.5f);
  seen.specular = glm::vec3(0.1f);
  for (const float roughness : {0.0f, 0.5f, 1.0f}) {
    seen.lobe.roughness = roughness;
    EXPECT_FLOAT_EQ(reflected_sky(nullptr, seen, {0, 1, 0}, {0, 1, 0}).r,
                    ambient_radiance * 0.5f + sky_radiance * mirrored_visibility(roughness) * 0.1f);
  }
  const Sky same{glm::vec3(sky_radiance)};
  EXPECT_FLOAT_EQ(reflected_sky(&same, seen, {0, 1, 0}, {0.6f, 0.8f, 0}).r,
                  reflected_sky(nullptr, seen, {0, 1, 0}, {0.6f, 0.8f, 0}).r);
}

TEST(Sky, GradientLightsSurfacesByItsClosedForm) {
  const Sky sky(glm::vec3(4.0f), glm::vec3(1.0f));
  const auto ambient = [&](glm::vec3 n) {
    return static_cast<double>(sky.ambient(n).r / sky_visibility);
  };
  EXPECT_NEAR(ambient({0, 1, 0}), 1.0 + 3.0 * 2.0 / 3.0, 1e-6);
  EXPECT_NEAR(ambient({1, 0, 0}), 1.0 + 3.0 * 2.0 / (3.0 * std::numbers::pi), 1e-6);
  EXPECT_NEAR(ambient({0, -1, 0}), 1.0, 1e-6);
  const Radiance radiance = [](glm::dvec3 d) { return 1.0 + 3.0 * std::max(0.0, d.y); };
  for (double v : {0.1, 0.3, 0.7}) {
    const glm::dvec3 n = direction_of(0.2, v);
    EXPECT_NEAR(ambient(n), irradiance(radiance, n), 1e-4) << v;
  }
}

TEST(Sky, GradientsMeanIsThatOfItsPatch) {
  const Sky sky(glm::vec3(1.0f), glm::vec3(0.0f));
  const Radiance radiance = [](glm::dvec3 d) { return std::max(0.0, d.y); };
  for (int i = 0; i < 200; ++i) {
    const Patch3 p = random_patch(i, i % 2 ? 0.1 : 1.0);
    // Error of the midpoint rule in quarters: at most that of a kink in one row of four.
    EXPECT_NEAR(mean_of(sky, p), brute_force(radiance, p), 0.004) << i;
  }
}

TEST(Sky, MapsMeanIsThatOfItsPatch) {
  const Radiance radiance = [](glm::dvec3 d) {
    return 1.0 + 0.4 * d.x + 0.3 * d.y * d.z + 0.3 * d.z * d.z * d.x;
  };
  const Sky sky(map_of(128, radiance), 0.0, "map");
  for (int i = 0; i < 400; ++i) {
    const Patch3 p = random_patch(i, i % 3 == 0 ? 0.02 : i % 3 == 1 ? 0.2 : 2.0);
    EXPECT_NEAR(mean_of(sky, p), brute_force(radiance, p), 0.004) << i;
    EXPECT_NEAR(static_cast<double>(sky.radiance(p.direction).g), radiance(p.direction), 0.001)
        << i;
  }
}

TEST(Sky, LobesSeeTheMeanAroundADirection) {
  const Radiance radiance = [](glm::dvec3 d) { return 1.0 + 0.5 * d.x + 0.3 * d.y * d.z; };
  const Sky sky(map_of(64, radiance), 0.0, "map");
  for (int i = 0; i < 100; ++i) {
    Patch3 p = random_patch(i, 1.0);
    const float width = 0.05f * static_cast<float>(i);
    p.right = width * glm::normalize(p.right);
    p.down = width * glm::normalize(p.down);
    EXPECT_NEAR(static_cast<double>(sky.around(p.direction, roughness_of(width)).g),
                brute_force(radiance, p), 0.05)
        << width;
  }
}

// The root mean square of the errors against sums of 64 x 64 directions, which are the mean of the
// same square. Sums of nine squares had 0.009 to 0.022 under soft boxes and 0.017 to 0.035 in the
// room with windows.
TEST(Sky, LobesOfRoomsAreNearTheSumOfManyDirections) {
  const auto error = [](Environment room, float roughness) {
    const Sky sky(room);
    const auto width = static_cast<float>(lobe_width(static_cast<double>(roughness)));
    constexpr int directions = 48;
    double squares = 0.0;
    for (int i = 0; i < directions; ++i) {
      Patch3 p = random_patch(4 * i + 1, 1.0);
      p.right = width * glm::vec3(any_perpendicular(glm::dvec3(p.direction)));
      p.down = glm::cross(p.direction, p.right);
      const auto point = [&](glm::dvec3 d) { return static_cast<double>(sky.radiance(d).g); };
      const double off =
          static_cast<double>(sky.around(p.direction, roughness).g) - brute_force(point, p);
      squares += off * off;
    }
    return std::sqrt(squares / directions);
  };
  for (const float roughness : {0.25f, 0.3f, 0.355f, 0.5f, 0.7f, 1.0f}) {
    EXPECT_LT(error(Environment::softboxes, roughness), 0.0095) << roughness;
    EXPECT_LT(error(Environment::windows, roughness), 0.0165) << roughness;
  }
}

// The map of a roughness is made when it is first used, by whichever thread.
TEST(Sky, LobesAreTheSameOnManyThreads) {
  const SkyMap map = noise_map(64);
  const SkyLobes alone(map), shared(map);
  constexpr int count = 64;
  std::array<glm::vec3, count> found;
  in_tasks(count, [&](std::size_t i) {
    const Patch3 p = random_patch(static_cast<int>(i), 1.0);
    found[i] = shared.around(p.direction, 0.25f + 0.012f * static_cast<float>(i));
  });
  for (int i = 0; i < count; ++i)
    EXPECT_EQ(found[static_cast<std::size_t>(i)],
              alone.around(random_patch(i, 1.0).direction, 0.25f + 0.012f * static_cast<float>(i)));
  EXPECT_LT(shared.memory_bytes(), std::size_t{2} << 20) << "with all roughnesses";
}

TEST(Sky, MapsMeanAveragesWhatAPatchHolds) {
  // A fine pattern with a known mean: alternate rows of 0 and 1.
  int texel = 0;
  const Sky sky(map_of(256, [&](glm::dvec3) { return texel++ / 512 % 2; }), 0.0, "map");
  for (int i = 0; i < 200; ++i)
    EXPECT_NEAR(mean_of(sky, random_patch(4 * i + 1, 1.0)), 0.5, 0.02) << i;
}

TEST(Sky, MapHasNoSeamAndNoPoles) {
  const Sky sky(noise_map(32), 0.0, "map");
  for (double side : {0.0, 0.03, 0.2, 0.7}) {
    const auto at = [&](glm::dvec3 d) {
      const glm::dvec3 right = glm::normalize(glm::cross(d, glm::dvec3(0.3, 0.2, 0.9)));
      return mean_of(sky, {d, side * right, side * glm::cross(d, right)});
    };
    for (int i = 1; i < 20; ++i)
      EXPECT_NEAR(at(direction_of(1e-7, i / 20.0)), at(direction_of(1.0 - 1e-7, i / 20.0)), 1e-4);
    for (double pole : {1e-7, 1.0 - 1e-7})
      for (int i = 0; i < 20; ++i)
        EXPECT_NEAR(at(direction_of(i / 20.0, pole)), at(direction_of(0.33, pole)), 1e-3) << side;
  }
}

TEST(Sky, WhatIsNoDirectionSeesNoNumber) {
  const Sky map(noise_map(32), 0.0, "map");
  const Sky gradient(glm::vec3(1), glm::vec3(0));
  const glm::vec3 nan(std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(std::isnan(map.radiance(nan).r));
  EXPECT_TRUE(std::isnan(map.radiance(nan, glm::vec3(0.1f), nan).r));
  EXPECT_TRUE(std::isnan(map.ambient(nan).r));
  EXPECT_TRUE(std::isnan(gradient.radiance(nan).r));
  EXPECT_TRUE(std::isnan(gradient.ambient(nan).r));
}

TEST(Sky, TurnsCounterClockwise) {
  const Sky straight(noise_map(32), 0.0, "map");
  const Sky turned(noise_map(32), 90.0, "map");
  for (int i = 0; i < 20; ++i) {
    const glm::vec3 d = random_patch(i, 1.0).direction;
    // Seen from above, with -Z up in the plan and +X right: from straight ahead to the left.
    const glm::vec3 from(d.z, d.y, -d.x);
    EXPECT_NEAR(turned.radiance(from).r, straight.radiance(d).r, 1e-4f);
    EXPECT_NEAR(turned.ambient(from).r, straight.ambient(d).r, 1e-5f);
  }
  EXPECT_EQ(straight.name(), "map");
  EXPECT_EQ(turned.name(), "map, turned by 90 degrees");
  EXPECT_EQ(Sky(glm::vec3(0.25f), glm::vec3(1, 0, 2)).name(), "0.25,0.25,0.25:1,0,2");
}

TEST(Sky, MapsPlacesAreThoseOfACameraAlongMinusZ) {
  // Bright where expected: ahead, right, above.
  for (const glm::dvec3 towards :
       {glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}) {
    const Sky sky(map_of(64, [&](glm::dvec3 d) { return glm::dot(d, towards) > 0.9 ? 1.0 : 0.0; }),
                  0.0, "map");
    EXPECT_EQ(sky.radiance(towards).r, 1.0f);
    EXPECT_EQ(sky.radiance(-towards).r, 0.0f);
  }
}

TEST(Sky, OneBrightRowLightsByItsClosedForm) {
  constexpr int height = 64;
  for (int row : {0, 5, 20, 31}) {
    std::vector<glm::vec3> texels(2 * height * height, glm::vec3(0.0f));
    std::fill_n(texels.begin() + 2 * height * row, 2 * height, glm::vec3(50.0f));
    const Sky sky(SkyMap(2 * height, height, std::move(texels)), 0.0, "row");
    const double s0 = std::sin(std::numbers::pi * row / height),
                 s1 = std::sin(std::numbers::pi * (row + 1) / height);
    // The integral of cos sin over the row, times 2 pi / pi.
    const double up = 50.0 * (s1 * s1 - s0 * s0);
    EXPECT_NEAR(static_cast<double>(sky.ambient({0, 1, 0}).r / sky_visibility), up, 1e-5 * up)
        << row;
    EXPECT_EQ(sky.ambient({0, -1, 0}).r, 0.0f) << "lights nothing from above";
    EXPECT_NEAR(sky.radiance(direction_of(0.3, (row + 0.5) / height)).r, 50.0f, 1e-4f);
  }
}

TEST(Sky, MapsIrradianceIsThatOfAllItsTexels) {
  const Radiance radiance = [](glm::dvec3 d) {
    return 0.2 + 5.0 * std::pow(std::max(0.0, glm::dot(d, glm::dvec3(0.6, 0.48, 0.64))), 40.0);
  };
  const Sky sky(map_of(256, radiance), 0.0, "map");
  double brightest = 0.0;
  for (int i = 0; i < 30; ++i)
    brightest = std::max(brightest, irradiance(radiance, random_patch(i, 1.0).direction));
  for (int i = 0; i < 30; ++i) {
    const glm::dvec3 n = random_patch(i, 1.0).direction;
    EXPECT_NEAR(static_cast<double>(sky.ambient(n).r / sky_visibility), irradiance(radiance, n),
                0.003 * brightest);
  }
}

}  // namespace
}  // namespace asos::test::sky_sums
