#pragma once

#include <nlohmann/json.hpp>

#include <random>
#include <span>
#include <string>

namespace asos::fuzz {

using Json = nlohmann::ordered_json;

/// Changes some values of a JSON document, which stays valid JSON: unlikely numbers and names, and
/// members that are removed, duplicated, swapped or moved. `words` are names that the reader
/// supports.
void mutate(Json& document, std::span<const char* const> words, std::mt19937& random);

/// An unlikely number: at the limits of types, near other limits, 0, tiny or huge.
[[nodiscard]] double unlikely_number(std::mt19937& random);

}  // namespace asos::fuzz
