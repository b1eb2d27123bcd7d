#include "tests/fuzz/json_mutator.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace asos::fuzz {
namespace {

std::size_t below(std::size_t count, std::mt19937& random) {
  return count == 0 ? 0 : random() % count;
}

void gather(Json& at, std::vector<Json*>& places) {
  places.push_back(&at);
  if (!at.is_structured()) return;
  for (Json& child : at) gather(child, places);
}

Json& any_of(const std::vector<Json*>& places, std::mt19937& random) {
  return *places[below(places.size(), random)];
}

Json other_value(std::span<const char* const> words, std::mt19937& random) {
  switch (random() % 12) {
    case 0:
      return nullptr;
    case 1:
      return Json::array();
    case 2:
      return Json::object();
    case 3:
      return std::string("\x1b[2J\n\xe2\x80\xae name");
    case 4:
      return random() % 2 == 0;
    case 5:
    case 6:
      return words[below(words.size(), random)];
    case 7:
      return static_cast<std::int64_t>(unlikely_number(random) < 0 ? -1 : random() % 70000);
    case 8:
    case 9:
      return random() % 12;
    default:
      return unlikely_number(random);
  }
}

// Sets a number near its old value, or something that is no number.
void change_number(Json& number, std::span<const char* const> words, std::mt19937& random) {
  if (random() % 3 == 0) {
    number = other_value(words, random);
  } else if (number.is_number_integer()) {
    // Wraps around at the ends of its type, as unsigned numbers do.
    number = static_cast<std::int64_t>(number.get<std::uint64_t>() + random() % 5 - 2);
  } else {
    constexpr std::array factors{0.0, -1.0, 0.5, 2.0, 1e-3, 1e3, 1e-20, 1e20, 1.0000001};
    number = number.get<double>() * factors[below(factors.size(), random)];
  }
}

void change_list(Json& list, const Json& graft, std::mt19937& random) {
  const std::size_t at = below(list.size(), random);
  const auto place = list.begin() + static_cast<std::ptrdiff_t>(at);
  switch (list.empty() ? 0 : random() % 5) {
    case 0:
      list.push_back(graft);
      return;
    case 1:
      list.erase(place);
      return;
    case 2:
      list.push_back(Json(*place));
      return;
    case 3:
      std::swap(list[at], list[below(list.size(), random)]);
      return;
    default:
      list.insert(place, Json(*place));
  }
}

void change_object(Json& object, const Json& graft, std::span<const char* const> words,
                   std::mt19937& random) {
  const std::size_t at = below(object.size(), random);
  const auto place = std::next(object.begin(), static_cast<std::ptrdiff_t>(at));
  switch (object.empty() ? 0 : random() % 3) {
    case 0:
      object[words[below(words.size(), random)]] = graft;
      return;
    case 1:
      object.erase(place);
      return;
    default: {
      Json moved = *place;
      object.erase(place);
      object[words[below(words.size(), random)]] = std::move(moved);
    }
  }
}

void change(Json& document, std::span<const char* const> words, std::mt19937& random) {
  std::vector<Json*> places;
  gather(document, places);
  Json& at = any_of(places, random);
  if (random() % 16 == 0) {
    at = other_value(words, random);
    return;
  }
  // A copy, because the grafted value may contain its destination.
  const Json graft = random() % 2 == 0 ? Json(any_of(places, random)) : other_value(words, random);
  if (at.is_number()) return change_number(at, words, random);
  if (at.is_array()) return change_list(at, graft, random);
  if (at.is_object()) return change_object(at, graft, words, random);
  at = graft;
}

}  // namespace

double unlikely_number(std::mt19937& random) {
  constexpr std::array numbers{0.0,
                               -0.0,
                               1.0,
                               -1.0,
                               0.5,
                               1e-7,
                               1e-38,
                               1e-45,
                               1e-300,
                               3.4028235e38,
                               -3.4028235e38,
                               1e300,
                               1e15,
                               1.1e15,
                               -9.9e14,
                               1e7,
                               16777217.0,
                               255.0,
                               256.0,
                               65535.0,
                               65536.0,
                               2147483647.0,
                               -2147483648.0,
                               4294967295.0,
                               4294967296.0,
                               1.8446744073709552e19,
                               1.5707963267948966,
                               3.141592653589793,
                               0.99999999,
                               1.00000001};
  return numbers[random() % numbers.size()];
}

void mutate(Json& document, std::span<const char* const> words, std::mt19937& random) {
  const unsigned changes = 1 + random() % 4;
  for (unsigned i = 0; i < changes; ++i) change(document, words, random);
}

}  // namespace asos::fuzz
