// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace galilean::monitor {

/// Reads the members of a JSON request. A member that is left out or has the wrong type is returned
/// as its default. The first member that is wrong becomes the objection, so ask for `objection`
/// after all members are read.
class RequestFields {
 public:
  /// A `request` that is no JSON object has no members, and that is the objection.
  /// Requires: `request` outlives this.
  explicit RequestFields(const nlohmann::json& request);

  [[nodiscard]] std::string text(const char* name, std::string absent = {});
  /// Returns the member if it is a whole number from `least` to `most`, both included.
  [[nodiscard]] int whole_number(const char* name, int absent,
                                 int least = std::numeric_limits<int>::min(),
                                 int most = std::numeric_limits<int>::max());
  /// Returns the member if it is a number from `least` to `most`, both included.
  [[nodiscard]] double number(const char* name, double absent, double least, double most);
  [[nodiscard]] bool flag(const char* name);
  [[nodiscard]] std::vector<std::string> names(const char* name);
  /// Returns the member if it is a list, else an empty list. To leave this member out is wrong.
  [[nodiscard]] const nlohmann::json& list(const char* name);
  /// Returns nullptr if the member is left out.
  [[nodiscard]] const nlohmann::json* find(const char* name) const;

  /// Makes `why`, which is one sentence, the objection unless there is one already.
  void refuse(std::string why);
  [[nodiscard]] bool ok() const noexcept { return objection_.empty(); }
  /// Returns one sentence for the client; it is empty if nothing is wrong.
  [[nodiscard]] const std::string& objection() const noexcept { return objection_; }

 private:
  const nlohmann::json& request_;
  std::string objection_;
};

}  // namespace galilean::monitor
