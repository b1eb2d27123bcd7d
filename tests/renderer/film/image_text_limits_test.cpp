#include "renderer/film/image_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <zlib.h>

namespace asos::image_text_limits_test {
namespace {

std::string big_endian(std::size_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& body) {
  const std::string whole = type + body;
  return big_endian(body.size()) + whole +
         big_endian(::crc32(0, reinterpret_cast<const Bytef*>(whole.data()),
                            static_cast<uInt>(whole.size())));
}

std::string deflated(const std::string& text) {
  uLongf size = ::compressBound(text.size());
  std::string packed(size, '\0');
  EXPECT_EQ(::compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                       reinterpret_cast<const Bytef*>(text.data()), text.size()),
            Z_OK);
  packed.resize(size);
  return packed;
}

/// The beginning of a PNG with these chunks, which is enough for reading its texts.
std::string png_with(const std::string& chunks) {
  return "\x89PNG\r\n\x1a\n" + chunks + chunk("IEND", "");
}

TEST(ImageTextLimits, TextIsCountedOverAllChunks) {
  using std::string_literals::operator""s;
  const test::TemporaryFolder folder;
  const std::string million(1'000'000, 'a');
  for (const bool packed : {false, true}) {
    const std::string one =
        packed ? chunk("zTXt", "key\0\0"s + deflated(million)) : chunk("tEXt", "key\0"s + million);
    std::string some, many;
    for (int i = 0; i < 16; ++i) some += one;
    for (int i = 0; i < 400; ++i) many += one;
    const auto read = read_image_text(folder.write("some.png", png_with(some)));
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->size(), 16u);
    const auto refused = read_image_text(folder.write("many.png", png_with(many)));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().reason.find("16 MB"), std::string::npos) << refused.error().reason;
  }
}

TEST(ImageTextLimits, OneChunkIsNotInflatedBeyondTheLimit) {
  using std::string_literals::operator""s;
  const test::TemporaryFolder folder;
  const std::string bomb = chunk("zTXt", "key\0\0"s + deflated(std::string(64u << 20, 'a')));
  EXPECT_FALSE(read_image_text(folder.write("bomb.png", png_with(bomb))));
}

TEST(ImageTextLimits, EmptyEntriesAreCounted) {
  using std::string_literals::operator""s;
  const test::TemporaryFolder folder;
  std::string many;
  for (int i = 0; i < 1'000'000; ++i) many += chunk("tEXt", "k\0"s);
  EXPECT_FALSE(read_image_text(folder.write("many.png", png_with(many))));
}

TEST(ImageTextLimits, AnExrsTextIsCountedToo) {
  const test::TemporaryFolder folder;
  Film film(1, 1);
  ImageText text;
  for (char key = 'a'; key <= 'q'; ++key)
    text.emplace_back(std::string(1, key), std::string(1 << 20, 'x'));
  ASSERT_TRUE(write_exr(folder.file("large.exr"), film, text));
  const auto refused = read_image_text(folder.file("large.exr"));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().reason.find("16 MB"), std::string::npos) << refused.error().reason;
  text.resize(15);
  ASSERT_TRUE(write_exr(folder.file("large.exr"), film, text));
  EXPECT_TRUE(read_image_text(folder.file("large.exr")));
}

TEST(ImageTextLimits, APngThatCannotHoldItsPixelsIsRefused) {
  using std::string_literals::operator""s;
  const test::TemporaryFolder folder;
  const std::string head =
      chunk("IHDR", big_endian(100'000) + big_endian(100'000) + "\x08\x02\0\0\0"s);
  const auto image =
      read_png(folder.write("large.png", png_with(head + chunk("IDAT", deflated("x")))));
  ASSERT_FALSE(image);
  EXPECT_NE(image.error().reason.find("cannot hold"), std::string::npos) << image.error().reason;
}

}  // namespace
}  // namespace asos::image_text_limits_test
