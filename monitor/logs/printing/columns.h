// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/result.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::logs {

/// Calls `take` for each value of a message that is no list and no struct, with its path, such as
/// "pose.position.x" or "items[0].name". `prefix` stands before all paths.
void for_each_value(
    const monitor::MessageTree& message, const std::string& prefix,
    const std::function<void(const std::string&, const monitor::MessageTree&)>& take);

/// Returns a value as one cell of comma-separated values, in quotes where it must be.
[[nodiscard]] std::string csv_cell(const monitor::MessageTree& value);
/// Returns a text as a cell.
[[nodiscard]] std::string csv_text(const std::string& text);

/// The columns of a table, in the order in which messages have their values.
class Columns {
 public:
  static constexpr std::size_t kMost = 4096;

  /// Adds those that the message has and that are new. Errors: there are more than kMost.
  Result<void> add(const monitor::MessageTree& message, const std::string& prefix);
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  /// Returns where a column stands. Requires: it was added.
  [[nodiscard]] std::size_t place_of(const std::string& name) const { return places_.at(name); }

 private:
  void insert(std::size_t place, const std::string& name);

  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> places_;
};

}  // namespace galilean::logs
