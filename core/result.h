// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace galilean {

/// What went wrong, in one sentence for the person who reads it: what, where, what to do.
struct Error {
  std::string message;
};

/// A value, or the reason why there is none.
template <class T, class E = Error>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(E error) : content_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool ok() const noexcept { return content_.index() == 0; }
  explicit operator bool() const noexcept { return ok(); }
  [[nodiscard]] T& value() & { return assert(ok()), std::get<0>(content_); }
  [[nodiscard]] const T& value() const& { return assert(ok()), std::get<0>(content_); }
  [[nodiscard]] T&& value() && { return assert(ok()), std::get<0>(std::move(content_)); }
  [[nodiscard]] const E& error() const& { return assert(!ok()), std::get<1>(content_); }

 private:
  std::variant<T, E> content_;
};

/// Success, which is `{}`, or the reason why it failed.
template <class E>
class [[nodiscard]] Result<void, E> {
 public:
  Result() = default;
  Result(E error) : error_(std::move(error)) {}

  [[nodiscard]] bool ok() const noexcept { return !error_; }
  explicit operator bool() const noexcept { return ok(); }
  [[nodiscard]] const E& error() const& { return assert(!ok()), *error_; }

 private:
  std::optional<E> error_;
};

}  // namespace galilean
