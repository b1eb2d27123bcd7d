#include "renderer/film/reduced_exr.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace asos::reduced_exr_test {
namespace {

class ReducedExr : public testing::Test {
 protected:
  ReducedExr() : film_(7, 5), path_(folder_.file("a.exr")) {
    for (std::size_t i = 0; i < film_.radiance.size(); ++i) {
      const auto value = static_cast<float>(i);
      film_.radiance[i] = {value, 2.0f * value, 1e-3f * value};
      film_.coverage.push_back(value / 100.0f);
    }
    EXPECT_TRUE(write_exr(path_, film_, {{"key", "value"}}));
  }

  test::TemporaryFolder folder_;
  Film film_;
  std::string path_;
};

TEST_F(ReducedExr, IsTheMeanOfItsPixels) {
  for (const std::int64_t most : {35, 34, 12, 11, 1}) {
    const MostPixels rule = [&](std::uint64_t) { return most; };
    const auto read = read_reduced_exr(path_, {}, rule);
    ASSERT_TRUE(read) << read.error().message();
    const int shrink = most >= 35 ? 1 : most >= 12 ? 2 : most >= 4 ? 4 : 8;
    EXPECT_EQ(read->attributes, (ImageText{{"key", "value"}}));
    const auto reduction = exr_reduction(path_, rule);
    ASSERT_TRUE(reduction);
    EXPECT_EQ(reduction->shrink, shrink);
    ASSERT_EQ(read->film.width, (7 + shrink - 1) / shrink);
    ASSERT_EQ(read->film.height, (5 + shrink - 1) / shrink);
    for (int y = 0; y < read->film.height; ++y) {
      for (int x = 0; x < read->film.width; ++x) {
        glm::dvec3 sum(0.0);
        double covered = 0.0, count = 0.0;
        for (int v = y * shrink; v < std::min((y + 1) * shrink, 5); ++v) {
          for (int u = x * shrink; u < std::min((x + 1) * shrink, 7); ++u, ++count) {
            sum += glm::dvec3(film_.radiance[film_.index(u, v)]);
            covered += static_cast<double>(film_.coverage[film_.index(u, v)]);
          }
        }
        const std::size_t at = read->film.index(x, y);
        for (int c = 0; c < 3; ++c)
          EXPECT_FLOAT_EQ(read->film.radiance[at][c], static_cast<float>(sum[c] / count));
        EXPECT_FLOAT_EQ(read->film.coverage[at], static_cast<float>(covered / count));
      }
    }
  }
}

TEST_F(ReducedExr, IsToldTheSizeOfItsFile) {
  std::uint64_t told = 0;
  const auto read = read_reduced_exr(path_, {}, [&](std::uint64_t bytes) {
    told = bytes;
    return std::int64_t{100};
  });
  ASSERT_TRUE(read);
  EXPECT_EQ(told, test::content_of(path_).size());
  EXPECT_FALSE(read_reduced_exr(folder_.file("none.exr"), {}, {}));
}

}  // namespace
}  // namespace asos::reduced_exr_test
