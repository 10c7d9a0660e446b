// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/wire/types/type_description.h"

namespace galilean::monitor {

/// The annotations before a definition or a field, as far as they change its encoding.
struct Annotations {
  wire::Extensibility extensibility = wire::Extensibility::kFinal;
  bool optional = false, key = false;
  std::optional<long long> value;
};

/// Walks through the tokens of a schema. After the first mistake it is no longer ok, and finds
/// nothing any more that is worth keeping.
class IdlReader {
 public:
  /// Requires: `text` outlives this.
  explicit IdlReader(std::string_view text);

  [[nodiscard]] bool ok() const noexcept { return problem_.empty(); }
  [[nodiscard]] bool at_end() const noexcept { return at_ == tokens_.size(); }
  /// Returns what is wrong, as a clause: "has 'x' where a name is expected".
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

  /// Returns the token here; an empty text at the end.
  [[nodiscard]] std::string_view next() const {
    return at_end() ? std::string_view() : tokens_[at_];
  }
  /// Returns the token here, and goes on behind it.
  std::string_view take() { return at_end() ? std::string_view() : tokens_[at_++]; }
  /// Takes the token if it is this one. Returns whether it is.
  bool accept(std::string_view token) { return next() == token && !take().empty(); }
  /// Takes this token; another one is a mistake.
  void expect(std::string_view token);
  /// Says that something else was expected here, such as "a name".
  void fail(const std::string& expected);

  /// Takes a name. It may have scopes: "geometry_msgs::msg::Point".
  [[nodiscard]] std::string name();
  [[nodiscard]] Annotations annotations();
  /// Takes a token that must be a whole number, if it is one.
  [[nodiscard]] static std::optional<long long> whole_number(std::string_view token);

 private:
  std::vector<std::string_view> tokens_;
  std::size_t at_ = 0;
  std::string problem_;
};

}  // namespace galilean::monitor
