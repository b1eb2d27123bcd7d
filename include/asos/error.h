#pragma once

#include "asos/export.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>

/// The public interface of the ASOS renderer. Its functions throw nothing: failures are values. An
/// exception that a callback throws on the calling thread comes back as an error, too.
namespace asos::api {

enum class ErrorCode {
  invalid_argument,  ///< a value is out of range, or not finite
  cannot_open,       ///< a file cannot be read, or is damaged
  cannot_write,      ///< a file cannot be written
  unsupported,       ///< the method cannot render this scene
  cancelled,         ///< the caller asked for a stop
  out_of_memory,
  internal
};

/// Why a call failed. `subject` names the file, setting or object; `reason` is a text for a person.
struct ASOS_API Error {
  ErrorCode code = ErrorCode::internal;
  std::string subject = {};
  std::string reason = {};

  /// Returns both in one line that is safe to print: control characters are escaped.
  [[nodiscard]] std::string message() const;
};

/// A value, or the error in its place.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool has_value() const noexcept { return state_.index() == 0; }
  [[nodiscard]] explicit operator bool() const noexcept { return has_value(); }

  /// The value. Throws std::bad_variant_access where there is none.
  [[nodiscard]] T& value() & { return std::get<0>(state_); }
  [[nodiscard]] const T& value() const& { return std::get<0>(state_); }
  [[nodiscard]] T&& value() && { return std::get<0>(std::move(state_)); }
  [[nodiscard]] T& operator*() & { return value(); }
  [[nodiscard]] const T& operator*() const& { return value(); }
  [[nodiscard]] T&& operator*() && { return std::move(*this).value(); }
  [[nodiscard]] T* operator->() { return &value(); }
  [[nodiscard]] const T* operator->() const { return &value(); }

  /// The error. Throws std::bad_variant_access where there is a value.
  [[nodiscard]] const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// Success, or the error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  [[nodiscard]] bool has_value() const noexcept { return !error_; }
  [[nodiscard]] explicit operator bool() const noexcept { return has_value(); }
  /// The error. Throws std::bad_optional_access after success.
  [[nodiscard]] const Error& error() const { return error_.value(); }

 private:
  std::optional<Error> error_;
};

}  // namespace asos::api
