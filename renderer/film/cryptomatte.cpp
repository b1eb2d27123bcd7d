#include "renderer/film/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>

namespace asos {
namespace {

constexpr std::string_view key_prefix = "cryptomatte/";

std::uint32_t scrambled(std::uint32_t k) {
  k *= 0xcc9e2d51u;
  return std::rotl(k, 15) * 0x1b873593u;
}

/// Returns a JSON string; bytes beyond ASCII stay as they are.
std::string json_string(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') json += '\\';
    if (byte < 0x20)
      json += fmt::format("\\u{:04x}", byte);
    else
      json += c;
  }
  json += '"';
  return json;
}

std::string manifest_of(const std::vector<std::string>& names) {
  std::map<std::string, std::uint32_t> sorted;
  for (const std::string& name : names)
    sorted[name] = std::bit_cast<std::uint32_t>(cryptomatte_id(name));
  std::string json;
  for (const auto& [name, id] : sorted)
    json += fmt::format("{}{}:\"{:08x}\"", json.empty() ? "" : ",", json_string(name), id);
  return fmt::format("{{{}}}", json);
}

/// Sums a pixel's shares by Cryptomatte id and sorts them, largest first.
void merge_ids(const IdShares& shares, std::span<const float> ids,
               std::vector<std::pair<float, float>>& merged) {
  merged.clear();
  for (const IdShare& share : shares) {
    if (share.id >= ids.size()) continue;
    const float id = ids[share.id];
    const auto same = std::find_if(merged.begin(), merged.end(),
                                   [&](const auto& entry) { return entry.first == id; });
    if (same == merged.end())
      merged.emplace_back(id, share.share);
    else
      same->second += share.share;
  }
  std::stable_sort(merged.begin(), merged.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
}

}  // namespace

std::uint32_t murmur_hash(std::string_view text) {
  std::uint32_t hash = 0;
  const auto byte = [&](std::size_t i) {
    return std::uint32_t{static_cast<unsigned char>(text[i])};
  };
  const std::size_t whole = text.size() / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4) {
    hash ^= scrambled(byte(i) | byte(i + 1) << 8 | byte(i + 2) << 16 | byte(i + 3) << 24);
    hash = std::rotl(hash, 13) * 5u + 0xe6546b64u;
  }
  std::uint32_t rest = 0;
  for (std::size_t i = text.size(); i > whole; --i) rest = rest << 8 | byte(i - 1);
  hash ^= scrambled(rest);
  hash ^= static_cast<std::uint32_t>(text.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bu;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
  return hash ^ hash >> 16;
}

float cryptomatte_id(std::string_view name) {
  std::uint32_t bits = murmur_hash(name);
  const std::uint32_t exponent = bits >> 23 & 255u;
  if (exponent == 0 || exponent == 255) bits ^= 1u << 23;
  return std::bit_cast<float>(bits);
}

std::string Cryptomatte::channel_name(std::size_t i) const {
  return fmt::format("{}{:02}.{}", name, i / 4, "RGBA"[i % 4]);
}

Cryptomatte cryptomatte(std::string name, std::string_view kind, std::span<const IdShares> pixels,
                        std::span<const std::string> names) {
  Cryptomatte made;
  std::vector<std::string> all(names.begin(), names.end());
  for (const IdShares& shares : pixels)
    for (const IdShare& share : shares)
      if (share.id != no_id && share.id >= all.size()) all.resize(share.id + std::size_t{1});
  std::vector<float> ids;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].empty()) all[i] = fmt::format("{} {}", kind, i + 1);
    ids.push_back(cryptomatte_id(all[i]));
  }
  made.channels.assign(2 * cryptomatte_ranks, std::vector<float>(pixels.size(), 0.0f));
  std::vector<std::pair<float, float>> merged;
  for (std::size_t pixel = 0; pixel < pixels.size(); ++pixel) {
    merge_ids(pixels[pixel], ids, merged);
    for (std::size_t rank = 0; rank < std::min(cryptomatte_ranks, merged.size()); ++rank) {
      made.channels[2 * rank][pixel] = merged[rank].first;
      made.channels[2 * rank + 1][pixel] = merged[rank].second;
    }
  }
  const std::string key =
      fmt::format("{}{}/", key_prefix, fmt::format("{:08x}", murmur_hash(name)).substr(0, 7));
  made.attributes = {{key + "name", name},
                     {key + "hash", "MurmurHash3_32"},
                     {key + "conversion", "uint32_to_float32"},
                     {key + "manifest", manifest_of(all)}};
  made.name = std::move(name);
  return made;
}

bool is_cryptomatte_key(std::string_view key) {
  return key.starts_with(key_prefix);
}

}  // namespace asos
