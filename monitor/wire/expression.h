// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::monitor {

/// A condition over the newest messages of some topics:
///
///     expression = conjunction { "or" conjunction }
///     conjunction = comparison { "and" comparison }
///     comparison = TOPIC "." FIELD ( "==" | "!=" | "<" | "<=" | ">" | ">=" ) VALUE
///
/// The topic ends at the first dot. A VALUE is a number, true, false, or a text in double quotes.
class Expression {
 public:
  struct Comparison {
    std::string topic;  ///< without a leading slash
    std::string field, op;
    MessageTree value;
  };
  /// The newest message of each topic, by its name without a leading slash.
  using Newest = std::map<std::string, MessageTree>;

  /// Errors: the text is no expression; the error says where and what was expected.
  [[nodiscard]] static Result<Expression> parse(std::string_view text);
  /// Returns the topics that it asks about, each once.
  [[nodiscard]] std::vector<std::string> topics() const;
  /// A comparison is false while its topic has sent nothing. Errors: a message has no field of that
  /// name, or the value is of another kind than the field.
  [[nodiscard]] Result<bool> holds(const Newest& newest) const;

 private:
  std::vector<std::vector<Comparison>> alternatives_;
};

}  // namespace galilean::monitor
