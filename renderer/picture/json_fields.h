#pragma once

#include "renderer/result.h"

#include <fmt/format.h>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>

// Conversion between a struct's members and the fields of a JSON object, in both directions by one
// list of names. Numbers are written so that the same bits are read back.

namespace asos {

using OrderedJson = nlohmann::ordered_json;

/// Writes members in the order of the calls.
class FieldWriter {
 public:
  void operator()(const char* key, bool value) { json_[key] = value; }
  void operator()(const char* key, int value) { json_[key] = value; }
  void operator()(const char* key, float value) { json_[key] = value; }
  void operator()(const char* key, double value) { json_[key] = value; }
  void operator()(const char* key, const std::string& value) { json_[key] = value; }
  template <glm::length_t N, typename T, glm::qualifier Q>
  void operator()(const char* key, const glm::vec<N, T, Q>& value) {
    OrderedJson& list = json_[key] = OrderedJson::array();
    for (glm::length_t i = 0; i < N; ++i) list.push_back(value[i]);
  }
  /// Writes one of the names of a table such as leaf_names.
  template <typename Names, typename T>
  void named(const char* key, const Names& names, T value) {
    for (const auto& known : names)
      if (known.value == value) json_[key] = known.name;
  }
  /// Writes infinity as null.
  void unbounded(const char* key, double value) {
    json_[key] = std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
  }
  void other(const char* key, OrderedJson value) { json_[key] = std::move(value); }

  [[nodiscard]] OrderedJson take() { return std::move(json_); }

 private:
  OrderedJson json_ = OrderedJson::object();
};

/// Reads members. All must exist, and no other fields. Keeps the first fault.
class FieldReader {
 public:
  /// `where` is the object's name in errors. The object has to outlive the reader.
  FieldReader(const OrderedJson& object, std::string where)
      : object_(object), where_(std::move(where)) {
    if (!object.is_object()) fault_ = where_ + " is no object";
  }

  void operator()(const char* key, bool& value) {
    const OrderedJson* at = take(key);
    if (!at) return;
    if (!at->is_boolean()) return refuse(key, "is neither true nor false");
    value = at->get<bool>();
  }
  void operator()(const char* key, int& value) {
    const OrderedJson* at = take(key);
    if (!at) return;
    constexpr double lo = std::numeric_limits<int>::min(), hi = std::numeric_limits<int>::max();
    if (!at->is_number_integer() || !(at->get<double>() >= lo && at->get<double>() <= hi))
      return refuse(key, "is no whole number");
    value = at->get<int>();
  }
  void operator()(const char* key, double& value) {
    if (const OrderedJson* at = take(key)) number(key, *at, value);
  }
  void operator()(const char* key, float& value) {
    if (const OrderedJson* at = take(key)) number(key, *at, value);
  }
  void operator()(const char* key, std::string& value) {
    const OrderedJson* at = take(key);
    if (!at) return;
    if (!at->is_string()) return refuse(key, "is no text");
    value = at->get<std::string>();
  }
  template <glm::length_t N, typename T, glm::qualifier Q>
  void operator()(const char* key, glm::vec<N, T, Q>& value) {
    if (const OrderedJson* at = take(key)) vector(key, *at, value);
  }
  template <typename Names, typename T>
  void named(const char* key, const Names& names, T& value) {
    const OrderedJson* at = take(key);
    if (!at) return;
    if (at->is_string()) {
      for (const auto& known : names) {
        if (at->get<std::string>() != known.name) continue;
        value = known.value;
        return;
      }
    }
    refuse(key, "is none of the names that this version knows");
  }
  void unbounded(const char* key, double& value) {
    const OrderedJson* at = take(key);
    if (!at) return;
    if (at->is_null()) {
      value = std::numeric_limits<double>::infinity();
    } else {
      number(key, *at, value);
    }
  }
  /// Returns whether an optional field exists.
  [[nodiscard]] bool has(const char* key) const {
    return object_.is_object() && object_.contains(key);
  }
  /// Returns the field itself, for other readers; null if it does not exist, which is a fault.
  [[nodiscard]] const OrderedJson* take(const char* key) {
    if (!fault_.empty()) return nullptr;
    known_.insert(key);
    const auto at = object_.find(key);
    if (at != object_.end()) return &*at;
    fault_ = fmt::format("{} has no \"{}\"", where_, key);
    return nullptr;
  }
  /// Reads a vector that is not a field of the object, such as an element of a list.
  template <glm::length_t N, typename T, glm::qualifier Q>
  void vector(const char* key, const OrderedJson& json, glm::vec<N, T, Q>& value) {
    if (!json.is_array() || json.size() != static_cast<std::size_t>(N))
      return refuse(key, fmt::format("is no list of {} numbers", N));
    for (glm::length_t i = 0; i < N; ++i) number(key, json[static_cast<std::size_t>(i)], value[i]);
  }
  void refuse(const char* key, const std::string& fault) {
    if (fault_.empty()) fault_ = fmt::format("{}: \"{}\" {}", where_, key, fault);
  }

  /// Returns the first fault; empty if there is none.
  [[nodiscard]] std::string fault() const {
    if (!fault_.empty()) return fault_;
    for (const auto& [key, value] : object_.items())
      if (!known_.contains(key))
        return fmt::format("{}: this version knows no \"{}\"", where_, key);
    return "";
  }

 private:
  template <typename T>
  void number(const char* key, const OrderedJson& json, T& value) {
    constexpr auto largest = static_cast<double>(std::numeric_limits<T>::max());
    if (!json.is_number() || !(std::abs(json.get<double>()) <= largest))
      return refuse(key, "is no finite number");
    value = static_cast<T>(json.get<double>());
  }

  const OrderedJson& object_;
  std::string where_;
  std::string fault_;
  std::set<std::string> known_;
};

}  // namespace asos
