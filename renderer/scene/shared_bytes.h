#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace asos {

/// Bytes with copy-on-write: all copies share them until one is written to. Images are large, and
/// every scene, world and pose of a file holds them.
class SharedBytes {
 public:
  using Bytes = std::vector<std::uint8_t>;

  SharedBytes() = default;
  SharedBytes(Bytes bytes) : bytes_(std::make_shared<Bytes>(std::move(bytes))) {}
  SharedBytes(std::initializer_list<std::uint8_t> bytes) : SharedBytes(Bytes(bytes)) {}

  /// Returns the bytes of this copy for writing; they are no longer shared.
  [[nodiscard]] Bytes& own() {
    if (!bytes_) bytes_ = std::make_shared<Bytes>();
    if (bytes_.use_count() > 1) bytes_ = std::make_shared<Bytes>(*bytes_);
    return *bytes_;
  }

  [[nodiscard]] const Bytes& get() const {
    static const Bytes none;
    return bytes_ ? *bytes_ : none;
  }
  [[nodiscard]] const std::uint8_t* data() const { return bytes_ ? bytes_->data() : nullptr; }
  [[nodiscard]] std::size_t size() const { return bytes_ ? bytes_->size() : 0; }
  [[nodiscard]] bool empty() const { return !bytes_ || bytes_->empty(); }
  [[nodiscard]] std::uint8_t operator[](std::size_t i) const { return (*bytes_)[i]; }
  [[nodiscard]] std::uint8_t at(std::size_t i) const { return get().at(i); }
  bool operator==(const SharedBytes& other) const { return get() == other.get(); }

 private:
  std::shared_ptr<Bytes> bytes_;
};

}  // namespace asos
