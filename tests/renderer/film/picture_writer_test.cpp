#include "renderer/film/picture_writer.h"

#include "renderer/film/image_text.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdint>
#include <png.h>
#include <random>
#include <span>
#include <string>
#include <sys/resource.h>
#include <zlib.h>

namespace asos {
namespace {

Film stripes(int width, int height) {
  Film film(width, height);
  for (std::size_t i = 0; i < film.radiance.size(); ++i)
    film.radiance[i] = {0.001f * static_cast<float>(i), 1.0f / 3.0f, -1e30f};
  return film;
}

class PictureWriterTest : public testing::Test {
 protected:
  [[nodiscard]] std::size_t files() const {
    const std::filesystem::directory_iterator all(folder.path());
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }
  test::TemporaryFolder folder;
};

// Writing rows in uneven portions gives the same file as writing the whole film.
TEST_F(PictureWriterTest, PortionsGiveTheWholeFile) {
  const Film film = stripes(37, 23);
  const ImageText text{{"k", "ä"}, {"l", "m"}};
  ASSERT_TRUE(write_png(folder.file("a.png"), film, 0.5f, text));
  ASSERT_TRUE(write_exr(folder.file("a.exr"), film, text));
  for (const bool exr : {false, true}) {
    const std::string to = folder.file(exr ? "b.exr" : "b.png");
    auto writer =
        exr ? make_exr_writer(to, {37, 23}, text) : make_png_writer(to, {37, 23}, 0.5f, text);
    ASSERT_TRUE(writer) << writer.error().message();
    std::size_t y = 0;
    for (const std::size_t rows : {1u, 17u, 0u, 5u}) {
      ASSERT_TRUE((*writer)->add_rows(std::span(film.radiance).subspan(37 * y, 37 * rows)));
      y += rows;
    }
    ASSERT_TRUE((*writer)->finish());
  }
  EXPECT_EQ(test::content_of(folder.file("a.png")), test::content_of(folder.file("b.png")));
  EXPECT_EQ(test::content_of(folder.file("a.exr")), test::content_of(folder.file("b.exr")));
  EXPECT_EQ(read_exr(folder.file("b.exr")).value().film.radiance, film.radiance);
}

// PNG has straight alpha, EXR premultiplied; fully transparent pixels have no colour.
TEST_F(PictureWriterTest, CoverageIsTheAlphaChannel) {
  Film film(3, 1);
  film.radiance = {{0.25f, 0.5f, 0.0f}, {0.0f, 0.0f, 0.0f}, {0.5f, 4.0f, 1.0f}};
  film.coverage = {0.5f, 0.0f, 1.0f};
  ASSERT_TRUE(write_exr(folder.file("a.exr"), film, {}));
  const Film read = read_exr(folder.file("a.exr")).value().film;
  EXPECT_EQ(read.radiance, film.radiance);
  EXPECT_EQ(read.coverage, film.coverage);
  ASSERT_TRUE(write_png(folder.file("a.png"), film, 0.0f, {}));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_file(&image, folder.file("a.png").c_str()));
  EXPECT_EQ(image.format & PNG_FORMAT_FLAG_ALPHA, PNG_FORMAT_FLAG_ALPHA);
  image.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
  ASSERT_TRUE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr));
  const glm::u8vec3 first = display_bytes(glm::vec3(0.5f, 1.0f, 0.0f), 0.0f);
  const glm::u8vec3 last = display_bytes(glm::vec3(0.5f, 4.0f, 1.0f), 0.0f);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{first.x, first.y, first.z, 128, 0, 0, 0, 0, last.x,
                                              last.y, last.z, 255}));
  film.coverage.clear();
  ASSERT_TRUE(write_png(folder.file("b.png"), film, 0.0f, {}));
  ASSERT_TRUE(png_image_begin_read_from_file(&image, folder.file("b.png").c_str()));
  EXPECT_EQ(image.format & PNG_FORMAT_FLAG_ALPHA, 0u) << "a fully covered picture has no alpha";
  png_image_free(&image);
}

TEST_F(PictureWriterTest, UnfinishedFilesAreRemoved) {
  folder.write("old.png", "old");
  for (const char* name : {"old.png", "new.exr"}) {
    const std::string to = folder.file(name);
    auto writer = to.ends_with("exr") ? make_exr_writer(to, {8, 8}, {})
                                      : make_png_writer(to, {8, 8}, 0.0f, {});
    ASSERT_TRUE(writer);
    ASSERT_TRUE((*writer)->add_rows(stripes(8, 3).radiance));
  }
  EXPECT_EQ(test::content_of(folder.file("old.png")), "old");
  EXPECT_EQ(files(), 1u);
  const auto nowhere = make_exr_writer(folder.file("no/x.exr"), {8, 8}, {});
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().subject, folder.file("no/x.exr"));
}

// Writing fails somewhere in the middle, as on a full disk.
TEST_F(PictureWriterTest, WhatCannotBeWrittenToTheEndIsAnErrorWithItsReason) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 20000;
  setrlimit(RLIMIT_FSIZE, &small);
  Film film(200, 200);
  for (std::uint32_t i = 0; i < 200 * 200; ++i)
    film.radiance[i] = glm::vec3(static_cast<float>(i * 2654435761u));
  const Result<void> exr = write_exr(folder.file("a.exr"), film, {});
  const Result<void> bytes =
      write_file_atomically(folder.file("a.bin"), std::vector<std::uint8_t>(50000));
  RgbImage noise{200, 200, {}, {}};
  std::mt19937 random;
  for (std::uint32_t i = 0; i < 3 * 200 * 200; ++i)
    noise.rgb.push_back(static_cast<std::uint8_t>(random() >> 24));
  const Result<void> png = write_png(folder.file("a.png"), noise);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  for (const Result<void>& written : {exr, bytes, png}) {
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().reason.find("File too large"), std::string::npos)
        << written.error().message();
  }
  EXPECT_EQ(files(), 0u);
}

void append_number(std::string& out, std::uint32_t n) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(n >> shift);
}

std::string chunk(const std::string& type, const std::string& body) {
  const std::string all = type + body;
  std::string out;
  append_number(out, static_cast<std::uint32_t>(body.size()));
  out += all;
  append_number(out, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(all.data()),
                                                      static_cast<uInt>(all.size()))));
  return out;
}

std::string packed(const std::string& text) {
  std::string out(compressBound(text.size()), '\0');
  uLongf size = out.size();
  compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
           text.size());
  return out.substr(0, size);
}

TEST(WrittenFiles, LinksAreFollowed) {
  namespace fs = std::filesystem;
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "there");
  folder.write("there/old.bin", "old");
  fs::create_symlink("there/old.bin", folder.path() / "link.bin");
  fs::create_symlink("there/new.bin", folder.path() / "dangling.bin");
  for (const char* link : {"link.bin", "dangling.bin"}) {
    ASSERT_TRUE(write_file_atomically(folder.file(link), {'n', 'e', 'w'}));
    EXPECT_TRUE(fs::is_symlink(folder.path() / link)) << link;
  }
  EXPECT_EQ(test::content_of(folder.path() / "there/old.bin"), "new");
  EXPECT_EQ(test::content_of(folder.path() / "there/new.bin"), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "there"), {}), 2);
}

// Other programs compress the texts of a PNG and move them.
TEST_F(PictureWriterTest, TextsOfOtherProgramsAreRead) {
  using namespace std::string_literals;
  ASSERT_TRUE(write_png(folder.file("a.png"), stripes(2, 2), 0.0f, {}));
  const std::string png = test::content_of(folder.file("a.png"));
  const std::string end = png.substr(png.size() - 12), body = png.substr(0, png.size() - 12);
  const std::string long_text(100000, 'x');
  folder.write("b.png", body + chunk("zTXt", "one\0\0"s + packed(long_text)) +
                            chunk("iTXt", "two\0\1\0en\0zwei\0"s + packed("ä")) +
                            chunk("iTXt", "three\0\0\0\0\0ö"s) + end);
  const auto text = read_image_text(folder.file("b.png"));
  ASSERT_TRUE(text) << text.error().message();
  EXPECT_EQ(*text, (ImageText{{"one", long_text}, {"two", "ä"}, {"three", "ö"}}));

  std::string damaged = chunk("tEXt", "one\0two"s);
  damaged[10] ^= 1;
  for (const std::string& bad :
       {damaged, chunk("zTXt", "one\0\0no zlib"s), chunk("tEXt", "no end"), chunk("iTXt", "a\0"s),
        chunk("zTXt", "bomb\0\0"s + packed(std::string(17u << 20, ' ')))}) {
    const std::string file = folder.write("c.png", body + bad + end);
    const auto refused = read_image_text(file);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().subject, file);
  }
}

}  // namespace
}  // namespace asos
