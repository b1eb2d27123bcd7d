#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/layers.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Cryptomatte 1.2.0 (Friedman and Jones, Psyop): ids as hashes of names, with their coverage, in
// ordinary channels of an EXR.

namespace asos {

/// MurmurHash3_x86_32 with the seed 0.
[[nodiscard]] std::uint32_t murmur_hash(std::string_view text);
/// Returns a name's id: the name's hash as the bits of a float that is neither 0, denormal,
/// infinite nor NaN.
[[nodiscard]] float cryptomatte_id(std::string_view name);

/// Largest number of ids of one pixel in a file; those with the smallest coverage are dropped.
inline constexpr std::size_t cryptomatte_ranks = 6;

/// One Cryptomatte layer of a picture.
struct Cryptomatte {
  std::string name;                          ///< "CryptoObject"
  ImageText attributes;                      ///< its metadata, with the manifest
  std::vector<std::vector<float>> channels;  ///< planes: id, coverage, id, ... by rank

  /// The name of channel i: "CryptoObject00.R".
  [[nodiscard]] std::string channel_name(std::size_t i) const;
};

/// `names`: of each id; ids without one are called `kind` and their number, from 1. Ids of equal
/// names are one. The background has no rank.
[[nodiscard]] Cryptomatte cryptomatte(std::string name, std::string_view kind,
                                      std::span<const IdShares> pixels,
                                      std::span<const std::string> names);

/// Returns whether a string attribute of an EXR belongs to Cryptomatte.
[[nodiscard]] bool is_cryptomatte_key(std::string_view key);

}  // namespace asos
