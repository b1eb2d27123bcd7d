#include "renderer/film/cryptomatte.h"

#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <vector>

namespace asos {
namespace {

std::uint32_t bits_of(const char* name) {
  return std::bit_cast<std::uint32_t>(cryptomatte_id(name));
}

// Appleby's reference values, and names of the specification's sample pictures.
TEST(Cryptomatte, HashesAsMurmurHash3Does) {
  EXPECT_EQ(murmur_hash(""), 0u);
  EXPECT_EQ(murmur_hash("test"), 0xba6bd213u);
  EXPECT_EQ(murmur_hash("hello"), 0x248bfa47u);
  EXPECT_EQ(murmur_hash("hello, world"), 0x149bbb7fu);
  EXPECT_EQ(murmur_hash("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
  EXPECT_EQ(bits_of("Box001"), 0x6d15e631u);
  EXPECT_EQ(bits_of("bunny"), 0x13851a76u);
}

// Hashes whose exponent is 0 or 255 have the exponent's lowest bit flipped.
TEST(Cryptomatte, IdsAreFiniteNumbers) {
  int flipped = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::string name = "object " + std::to_string(i);
    const std::uint32_t hash = murmur_hash(name), id = bits_of(name.c_str());
    const std::uint32_t exponent = hash >> 23 & 255u;
    const bool special = exponent == 0 || exponent == 255;
    EXPECT_EQ(id, special ? hash ^ 1u << 23 : hash) << name;
    flipped += special;
  }
  EXPECT_GT(flipped, 10);
}

TEST(Cryptomatte, RanksHoldLargestCoveragesFirst) {
  const std::vector<IdShares> pixels{
      {{1, 0.5f}, {no_id, 0.3f}, {0, 0.2f}}, {{no_id, 1.0f}}, {{0, 0.25f}, {2, 0.5f}}};
  const std::vector<std::string> names{"Box001", "bunny", ""};
  const Cryptomatte made = cryptomatte("crypto_object", "object", pixels, names);
  ASSERT_EQ(made.channels.size(), 2 * cryptomatte_ranks);
  EXPECT_EQ(made.channel_name(0), "crypto_object00.R");
  EXPECT_EQ(made.channel_name(7), "crypto_object01.A");
  EXPECT_EQ(made.channels[0][0], cryptomatte_id("bunny"));
  EXPECT_EQ(made.channels[1][0], 0.5f);
  EXPECT_EQ(made.channels[2][0], cryptomatte_id("Box001"));
  EXPECT_EQ(made.channels[3][0], 0.2f);
  EXPECT_EQ(made.channels[5][0], 0.0f);
  EXPECT_EQ(made.channels[1][1], 0.0f) << "the background has no rank";
  EXPECT_EQ(made.channels[0][2], cryptomatte_id("object 3"));
  ASSERT_EQ(made.attributes.size(), 4u);
  EXPECT_EQ(made.attributes[0].first, "cryptomatte/f834d0a/name");
  EXPECT_EQ(made.attributes[0].second, "crypto_object");
  EXPECT_EQ(made.attributes[1].second, "MurmurHash3_32");
  EXPECT_EQ(made.attributes[2].second, "uint32_to_float32");
  EXPECT_EQ(made.attributes[3].first, "cryptomatte/f834d0a/manifest");
  EXPECT_NE(made.attributes[3].second.find("\"Box001\":\"6d15e631\""), std::string::npos);
}

TEST(Cryptomatte, EqualNamesAreOneId) {
  const std::vector<IdShares> pixels{{{0, 0.4f}, {2, 0.35f}, {1, 0.25f}}};
  const std::vector<std::string> names{"leaf", "stem", "leaf"};
  const Cryptomatte made = cryptomatte("CryptoObject", "object", pixels, names);
  EXPECT_EQ(made.channels[0][0], cryptomatte_id("leaf"));
  EXPECT_FLOAT_EQ(made.channels[1][0], 0.75f);
  EXPECT_EQ(made.channels[2][0], cryptomatte_id("stem"));
}

TEST(Cryptomatte, ManifestEscapesNames) {
  const std::vector<std::string> names{"a\"b\\c\n"};
  const std::string manifest = cryptomatte("X", "object", {}, names).attributes[3].second;
  EXPECT_EQ(manifest.substr(0, 17), "{\"a\\\"b\\\\c\\u000a\":") << manifest;
}

}  // namespace
}  // namespace asos
