#include "renderer/film/image_io.h"

#include "renderer/film/split_map.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <unistd.h>

namespace asos {
namespace {

/// Has a temporary folder whose name contains a space and a non-ASCII letter.
class ImageIo : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    dir_ = std::filesystem::temp_directory_path() /
           ("asos bild\xc3\xa4r " + std::to_string(::getpid()) + info->name());
    std::filesystem::create_directories(dir_);
  }
  void TearDown() override { std::filesystem::remove_all(dir_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (dir_ / name).string(); }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(dir_), {}));
  }

  std::filesystem::path dir_;
};

RgbImage gradient(int width, int height) {
  RgbImage image{width, height, {}, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const int c : {x * 7, y * 11, x * y}) {
        image.rgb.push_back(static_cast<std::uint8_t>(c));
      }
    }
  }
  return image;
}

Film film_of(int width, int height) {
  Film film(width, height);
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const auto f = static_cast<float>(i);
    film.radiance[i] = {f * 0.001f, 1000.0f / (f + 1.0f), f == 3.0f ? 1e-30f : -f};
    film.split_level[i] = static_cast<std::uint8_t>(i % 4);
  }
  return film;
}

const ImageText words{{"Software", "ASOS"},
                      {"asos:settings", "{\"max_level\": 3, \"eps\": 0.00390625}\nsecond line"},
                      {"Title", "Fahrrad für Zoë"},
                      {"Comment", "two  spaces"}};

TEST_F(ImageIo, PngComesBackWithItsText) {
  RgbImage image = gradient(37, 21);
  image.text = words;
  ASSERT_TRUE(write_png(path("a b.png"), image).has_value());
  const auto read = read_png(path("a b.png"));
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(read->width, 37);
  EXPECT_EQ(read->height, 21);
  EXPECT_EQ(read->rgb, image.rgb);
  EXPECT_EQ(read->text, words);
  EXPECT_EQ(files(), 1u) << "the temporary file stayed";
}

TEST_F(ImageIo, TextChunksHaveTheirChecksums) {
  // The CRC of the specification's example, the IEND chunk, is AE 42 60 82. Others are checked by a
  // bitwise implementation.
  RgbImage image = gradient(2, 2);
  image.text = words;
  ASSERT_TRUE(write_png(path("c.png"), image).has_value());
  const std::string file = test::content_of(path("c.png"));
  const auto number = [&](std::size_t at) {
    std::uint32_t n = 0;
    for (std::size_t i = 0; i < 4; ++i) n = n << 8 | static_cast<std::uint8_t>(file[at + i]);
    return n;
  };
  std::size_t chunks = 0;
  for (std::size_t at = 8; at < file.size(); at += number(at) + 12) {
    ++chunks;
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = 0; i < number(at) + 4; ++i) {
      crc ^= static_cast<std::uint8_t>(file[at + 4 + i]);
      for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1u ? 0xedb88320u : 0u);
    }
    EXPECT_EQ(number(at + 8 + number(at)), ~crc) << file.substr(at + 4, 4);
  }
  EXPECT_EQ(chunks, 3u + words.size());
  EXPECT_EQ(file.substr(12, 4), "IHDR");
}

TEST_F(ImageIo, PngShowsTheFilmAsTheDisplayDoes) {
  const Film film = film_of(5, 4);
  ASSERT_TRUE(write_png(path("f.png"), film, 1.0f, {}).has_value());
  const auto read = read_png(path("f.png"));
  ASSERT_TRUE(read.has_value());
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const glm::u8vec3 c = display_bytes(film.radiance[i], 1.0f);
    EXPECT_EQ(read->rgb[3 * i], c.r);
    EXPECT_EQ(read->rgb[3 * i + 2], c.b);
  }
}

TEST_F(ImageIo, SplitMapHasTheSplitColours) {
  const Film film = film_of(8, 2);
  ASSERT_TRUE(write_split_map_png(path("s.png"), film, {SplitMapColours::level}).has_value());
  const auto read = read_png(path("s.png"));
  ASSERT_TRUE(read.has_value());
  for (std::size_t i = 0; i < film.split_level.size(); ++i) {
    EXPECT_EQ(read->rgb[3 * i + 1], SplitMapKey{}.colour(SplitMapKey{}.value(film, i)).g);
  }
}

TEST_F(ImageIo, SplitMapHasTheCausesColours) {
  Film film(static_cast<int>(split_cause_count), 1);
  for (std::size_t i = 0; i < split_cause_count; ++i) {
    film.cause[i] = static_cast<SplitCause>(i);
    film.split_level[i] = 1;
  }
  ASSERT_TRUE(write_split_map_png(path("c.png"), film, {SplitMapColours::cause}).has_value());
  const auto read = read_png(path("c.png"));
  ASSERT_TRUE(read.has_value());
  for (std::size_t i = 0; i < split_cause_count; ++i) {
    const glm::u8vec3 c = split_cause_colour(static_cast<SplitCause>(i));
    EXPECT_EQ(glm::u8vec3(read->rgb[3 * i], read->rgb[3 * i + 1], read->rgb[3 * i + 2]), c) << i;
  }
}

TEST_F(ImageIo, ExrComesBackBitForBitWithItsAttributes) {
  const Film film = film_of(33, 19);
  ASSERT_TRUE(write_exr(path("a.exr"), film, words).has_value());
  const auto read = read_exr(path("a.exr"));
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(read->film.width, 33);
  EXPECT_EQ(read->film.height, 19);
  EXPECT_EQ(read->film.radiance, film.radiance);
  ImageText sorted = words;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(read->attributes, sorted);
}

TEST_F(ImageIo, OverwritesAWholeFileOrNothing) {
  ASSERT_TRUE(write_png(path("x.png"), gradient(3, 3)).has_value());
  ASSERT_TRUE(write_png(path("x.png"), gradient(9, 2)).has_value());
  EXPECT_EQ(read_png(path("x.png"))->width, 9);
  RgbImage wrong = gradient(4, 4);
  wrong.rgb.pop_back();
  EXPECT_FALSE(write_png(path("x.png"), wrong).has_value());
  EXPECT_EQ(read_png(path("x.png"))->width, 9);
  // A folder cannot be replaced by a file, and no temporary file is left.
  std::filesystem::create_directories(path("folder/inside"));
  const auto refused = write_png(path("folder"), gradient(3, 3));
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(files(), 2u);
}

TEST_F(ImageIo, ErrorsNameFileAndReason) {
  const std::string nowhere = path("missing/deep.png");
  const auto no_folder = write_png(nowhere, gradient(2, 2));
  ASSERT_FALSE(no_folder.has_value());
  EXPECT_EQ(no_folder.error().subject, nowhere);
  EXPECT_NE(no_folder.error().reason.find("No such file"), std::string::npos)
      << no_folder.error().reason;

  EXPECT_FALSE(write_png(path("e.png"), RgbImage{}).has_value());
  EXPECT_FALSE(write_exr(path("e.exr"), Film{}, {}).has_value());
  for (const std::string& key : {std::string(), std::string(80, 'k'), std::string(" lead"),
                                 std::string("new\nline"), std::string("\xc3\xa4")}) {
    RgbImage image = gradient(2, 2);
    image.text = {{key, "v"}};
    EXPECT_FALSE(write_png(path("k.png"), image).has_value()) << key;
  }
  EXPECT_FALSE(write_exr(path("k.exr"), film_of(2, 2), {{std::string(300, 'k'), "v"}}).has_value());
  EXPECT_EQ(files(), 0u);
}

TEST_F(ImageIo, GarbageIsRefused) {
  EXPECT_FALSE(read_png(path("none.png")).has_value());
  EXPECT_FALSE(read_exr(path("none.exr")).has_value());
  ASSERT_TRUE(write_png(path("g.png"), gradient(9, 9)).has_value());
  ASSERT_TRUE(write_exr(path("g.exr"), film_of(9, 9), words).has_value());
  for (const std::string& name : {std::string("g.png"), std::string("g.exr")}) {
    const std::string whole = test::content_of(path(name));
    for (const std::size_t length : {std::size_t{0}, std::size_t{4}, std::size_t{40}}) {
      std::ofstream(path("cut"), std::ios::binary) << whole.substr(0, length);
      EXPECT_FALSE(read_png(path("cut")).has_value()) << name << " " << length;
      EXPECT_FALSE(read_exr(path("cut")).has_value()) << name << " " << length;
    }
  }
}

}  // namespace
}  // namespace asos
