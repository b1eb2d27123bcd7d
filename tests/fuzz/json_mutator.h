#pragma once

#include <nlohmann/json.hpp>

#include <random>
#include <span>
#include <string>

namespace asos::fuzz {

using Json = nlohmann::ordered_json;

/// Changes some values of a JSON document and leaves it a document: unlikely numbers and names,
/// members that are left out, doubled, swapped or grafted elsewhere. `words` are names that the
/// reader knows.
void mutate(Json& document, std::span<const char* const> words, std::mt19937& random);

/// A number that few have thought of: at the ends of types, about limits, 0, tiny, huge.
[[nodiscard]] double unlikely_number(std::mt19937& random);

}  // namespace asos::fuzz
