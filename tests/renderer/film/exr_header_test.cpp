#include "renderer/film/exr_header.h"

#include "renderer/film/image_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <sys/resource.h>

namespace asos {
namespace {

std::string word(std::uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

std::string attribute(const std::string& type, const std::string& value, std::uint32_t claimed) {
  return "a" + std::string(1, '\0') + type + std::string(1, '\0') + word(claimed) + value;
}

/// A written file with additional bytes at the start of its header.
std::string with_attribute(const std::string& whole, const std::string& attribute) {
  return whole.substr(0, 8) + attribute + whole.substr(8);
}

std::string fault_of(const std::string& file) {
  return exr_header_error({reinterpret_cast<const std::uint8_t*>(file.data()), file.size()});
}

/// Peak memory of this process.
double peak_mb() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024.0;
}

class ExrClaims : public testing::Test {
 protected:
  ExrClaims() {
    Film film(16, 8);
    for (glm::vec3& pixel : film.radiance) pixel = {0.25f, 0.5f, 1.0f};
    EXPECT_TRUE(write_exr(folder_.file("whole.exr"), film, {{"key", "value"}}));
    whole_ = test::content_of(folder_.file("whole.exr"));
  }
  test::TemporaryFolder folder_;
  std::string whole_;
};

TEST_F(ExrClaims, HonestSizesAreAccepted) {
  EXPECT_EQ(fault_of(whole_), "");
  EXPECT_EQ(fault_of(with_attribute(whole_, attribute("string", "abc", 3))), "");
  const auto read = read_exr(folder_.file("whole.exr"));
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->film.radiance[5], glm::vec3(0.25f, 0.5f, 1.0f));
}

TEST_F(ExrClaims, OfMoreThanTheFileHoldsAreRefusedBeforeMemoryIsTaken) {
  constexpr std::uint32_t sizes[] = {0x6c206b73u, 0x7fffffffu, 0x80000000u, 0xffffffffu};
  for (const char* type : {"string", "floatvector", "stringvector", "preview", "unheard of"}) {
    for (const std::uint32_t size : sizes) {
      const std::string path =
          folder_.write("claims.exr", with_attribute(whole_, attribute(type, "abcd", size)));
      const double before = peak_mb();
      const auto picture = read_exr(path);
      ASSERT_FALSE(picture) << type << size;
      EXPECT_NE(picture.error().reason.find("claims " + std::to_string(size)), std::string::npos)
          << picture.error().reason;
      ASSERT_FALSE(read_image_text(path)) << type << size;
      EXPECT_LT(peak_mb() - before, 100.0) << type << size;
    }
  }
}

TEST_F(ExrClaims, OfPixelsThatNoCompressionCouldHoldAreRefusedBeforeMemoryIsTaken) {
  // The data window's last corner: 20,000 x 10,000.
  std::string huge = whole_;
  const std::size_t at = huge.find("dataWindow") + sizeof "dataWindow" + sizeof "box2i" + 4;
  huge.replace(at + 8, 8, word(19999) + word(9999));
  huge.append(20'000, '\0');  // enough for the table of row offsets
  const double before = peak_mb();
  const auto picture = read_exr(folder_.write("huge.exr", huge));
  ASSERT_FALSE(picture);
  EXPECT_NE(picture.error().reason.find("too early"), std::string::npos) << picture.error().reason;
  EXPECT_LT(peak_mb() - before, 100.0);
}

TEST_F(ExrClaims, CutOffAnywhereAreNoHarm) {
  const std::size_t header = whole_.find("screenWindowWidth");
  ASSERT_NE(header, std::string::npos);
  for (std::size_t size = 0; size < header; ++size)
    EXPECT_NE(fault_of(whole_.substr(0, size)), "") << size;
  // Every part of a multi-part file is checked.
  std::string parts = whole_.substr(0, header);
  parts[5] = 0x10;
  const std::string second = attribute("string", "", 0x7fffffffu);
  EXPECT_EQ(fault_of(parts + std::string(2, '\0')), "");
  EXPECT_NE(fault_of(parts + std::string(1, '\0') + second), "");
}

}  // namespace
}  // namespace asos
