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
/// changed. Copies share the array until one is written to.
template <typename T>
class Attribute {
 public:
  using value_type = T;
  using Placed = T (*)(const Placements& all, std::uint32_t number);

  Attribute() = default;
  Attribute(std::initializer_list<T> own) : own_(std::make_shared<std::vector<T>>(own)) {}
  Attribute& operator=(std::initializer_list<T> own) {
    own_ = std::make_shared<std::vector<T>>(own);
    return *this;
  }
  Attribute& operator=(std::vector<T> own) {
    own_ = std::make_shared<std::vector<T>>(std::move(own));
    return *this;
  }

  [[nodiscard]] const T operator[](std::size_t i) const {
    if (!placed_ || i < own_size()) return (*own_)[i];
    return placed_(*places_, static_cast<std::uint32_t>(i - own_size()));
  }
  /// Returns an own value, for changes; throws std::out_of_range beyond the own values.
  [[nodiscard]] T& operator[](std::size_t i) { return own().at(i); }
  [[nodiscard]] std::size_t size() const { return own_size() + placed_count_; }
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
    return (a.own_ == b.own_ || a.own() == b.own()) && a.places_ == b.places_ &&
           a.placed_count_ == b.placed_count_;
  }

  [[nodiscard]] const std::vector<T>& own() const {
    static const std::vector<T> none;
    return own_ ? *own_ : none;
  }
  /// Returns the own values of this copy for changes; they are no longer shared.
  [[nodiscard]] std::vector<T>& own() {
    if (!own_) own_ = std::make_shared<std::vector<T>>();
    if (own_.use_count() > 1) {
      auto copy = std::make_shared<std::vector<T>>();
      copy->reserve(own_->size() + room_to_grow);
      copy->insert(copy->end(), own_->begin(), own_->end());
      own_ = std::move(copy);
    }
    return *own_;
  }
  [[nodiscard]] std::size_t own_size() const { return own_ ? own_->size() : 0; }
  /// Returns the own values, which do not change while the pointer exists; null: there are none.
  [[nodiscard]] std::shared_ptr<const std::vector<T>> shared() const { return own_; }
  /// Capacity that a copy has beyond its values, for a ground and for readers of whole registers.
  static constexpr std::size_t room_to_grow = 64;

  /// Adds the values of `count` placed vertices or triangles, which `placed` computes.
  void set_placed(std::shared_ptr<const Placements> places, std::size_t count, Placed placed) {
    places_ = std::move(places);
    placed_count_ = count;
    placed_ = places_ ? placed : nullptr;
  }

  // The following concern its own values.
  [[nodiscard]] auto begin() { return own().begin(); }
  [[nodiscard]] auto end() { return own().end(); }
  [[nodiscard]] T& back() { return own().back(); }
  void push_back(const T& value) { own().push_back(value); }
  template <typename... Arguments>
  T& emplace_back(Arguments&&... arguments) {
    return own().emplace_back(std::forward<Arguments>(arguments)...);
  }
  template <typename... Arguments>
  auto insert(typename std::vector<T>::const_iterator at, Arguments&&... arguments) {
    return own().insert(at, std::forward<Arguments>(arguments)...);
  }
  auto insert(typename std::vector<T>::const_iterator at, std::initializer_list<T> values) {
    return own().insert(at, values);
  }
  template <typename... Arguments>
  auto erase(Arguments&&... arguments) {
    return own().erase(std::forward<Arguments>(arguments)...);
  }
  template <typename... Arguments>
  void assign(Arguments&&... arguments) {
    own().assign(std::forward<Arguments>(arguments)...);
  }
  template <typename... Arguments>
  void resize(Arguments&&... arguments) {
    own().resize(std::forward<Arguments>(arguments)...);
  }
  void reserve(std::size_t count) { own().reserve(count); }
  void clear() { own_.reset(); }

 private:
  std::shared_ptr<std::vector<T>> own_;  // null: none
  std::shared_ptr<const Placements> places_;
  std::size_t placed_count_ = 0;
  Placed placed_ = nullptr;
};

}  // namespace asos
