#pragma once

#include "renderer/world/placements.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace asos {

/// The values of all vertices, or triangles, of a world: the world's own in an array, then those of
/// placed meshes, which are computed on access. It reads like one vector; only own values can be
/// changed.
template <typename T>
class Attribute {
 public:
  using value_type = T;
  using Placed = T (*)(const Placements& all, std::uint32_t number);

  Attribute() = default;
  Attribute(std::initializer_list<T> own) : own_(own) {}
  Attribute& operator=(std::initializer_list<T> own) {
    own_ = own;
    return *this;
  }
  Attribute& operator=(std::vector<T> own) {
    own_ = std::move(own);
    return *this;
  }

  [[nodiscard]] const T operator[](std::size_t i) const {
    if (!placed_ || i < own_.size()) return own_[i];
    return placed_(*places_, static_cast<std::uint32_t>(i - own_.size()));
  }
  /// Returns an own value, for changes; throws std::out_of_range beyond the own values.
  [[nodiscard]] T& operator[](std::size_t i) { return own_.at(i); }
  [[nodiscard]] std::size_t size() const { return own_.size() + placed_count_; }
  [[nodiscard]] bool empty() const { return size() == 0; }

  /// Iterates over all values in order.
  class Iterator {
   public:
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using reference = T;
    using pointer = const T*;
    using iterator_category = std::input_iterator_tag;

    Iterator() = default;
    Iterator(const Attribute* all, std::size_t at) : all_(all), at_(at) {}
    [[nodiscard]] T operator*() const { return (*all_)[at_]; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    Iterator operator++(int) { return {all_, at_++}; }
    bool operator==(const Iterator&) const = default;

   private:
    const Attribute* all_ = nullptr;
    std::size_t at_ = 0;
  };
  [[nodiscard]] Iterator begin() const { return {this, 0}; }
  [[nodiscard]] Iterator end() const { return {this, size()}; }

  /// Returns whether both have the same own values, and the same places of the same meshes.
  [[nodiscard]] friend bool operator==(const Attribute& a, const Attribute& b) {
    return a.own_ == b.own_ && a.places_ == b.places_ && a.placed_count_ == b.placed_count_;
  }

  [[nodiscard]] const std::vector<T>& own() const { return own_; }
  [[nodiscard]] std::vector<T>& own() { return own_; }

  /// Adds the values of `count` placed vertices or triangles, which `placed` computes.
  void set_placed(std::shared_ptr<const Placements> places, std::size_t count, Placed placed) {
    places_ = std::move(places);
    placed_count_ = count;
    placed_ = places_ ? placed : nullptr;
  }

  // The following concern its own values.
  [[nodiscard]] auto begin() { return own_.begin(); }
  [[nodiscard]] auto end() { return own_.end(); }
  [[nodiscard]] T& back() { return own_.back(); }
  void push_back(const T& value) { own_.push_back(value); }
  template <typename... Arguments>
  T& emplace_back(Arguments&&... arguments) {
    return own_.emplace_back(std::forward<Arguments>(arguments)...);
  }
  template <typename... Arguments>
  auto insert(typename std::vector<T>::const_iterator at, Arguments&&... arguments) {
    return own_.insert(at, std::forward<Arguments>(arguments)...);
  }
  auto insert(typename std::vector<T>::const_iterator at, std::initializer_list<T> values) {
    return own_.insert(at, values);
  }
  template <typename... Arguments>
  auto erase(Arguments&&... arguments) {
    return own_.erase(std::forward<Arguments>(arguments)...);
  }
  template <typename... Arguments>
  void assign(Arguments&&... arguments) {
    own_.assign(std::forward<Arguments>(arguments)...);
  }
  template <typename... Arguments>
  void resize(Arguments&&... arguments) {
    own_.resize(std::forward<Arguments>(arguments)...);
  }
  void reserve(std::size_t count) { own_.reserve(count); }
  void clear() { own_.clear(); }

 private:
  std::vector<T> own_;
  std::shared_ptr<const Placements> places_;
  std::size_t placed_count_ = 0;
  Placed placed_ = nullptr;
};

}  // namespace asos
