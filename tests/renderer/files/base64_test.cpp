#include "renderer/files/base64.h"

#include <gtest/gtest.h>

#include <array>
#include <string_view>
#include <vector>

namespace asos {
namespace {

std::string encoded(std::string_view text) {
  return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
}

TEST(Base64, GivesTheTestVectorsOfRfc4648) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST(Base64, HasBytesAboveSevenBits) {
  EXPECT_EQ(base64(std::array<std::uint8_t, 3>{0xff, 0xef, 0xbe}), "/+++");
  EXPECT_EQ(base64(std::array<std::uint8_t, 1>{0xff}), "/w==");
}

}  // namespace
}  // namespace asos
