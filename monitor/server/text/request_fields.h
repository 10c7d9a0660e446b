// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace galilean::monitor {

/// Reads the members of a request. One that is left out, or has the wrong type, is returned as its
/// default. The first that is wrong is kept as the objection: ask for it when all are read.
class RequestFields {
 public:
  /// `request` must outlive this; what is no object has no members and is wrong.
  explicit RequestFields(const nlohmann::json& request);

  [[nodiscard]] std::string text(const char* name, std::string absent = {});
  [[nodiscard]] int whole_number(const char* name, int absent);
  [[nodiscard]] double number(const char* name, double absent, double least, double most);
  [[nodiscard]] bool flag(const char* name);
  [[nodiscard]] std::vector<std::string> names(const char* name);
  /// Must be there.
  [[nodiscard]] const nlohmann::json& list(const char* name);
  /// Returns nullptr where it is left out.
  [[nodiscard]] const nlohmann::json* find(const char* name) const;

  /// Keeps `why`, one sentence, unless something was wrong before.
  void refuse(std::string why);
  [[nodiscard]] bool ok() const noexcept { return objection_.empty(); }
  /// One sentence for the request's author; empty if nothing is wrong.
  [[nodiscard]] const std::string& objection() const noexcept { return objection_; }

 private:
  const nlohmann::json& request_;
  std::string objection_;
};

}  // namespace galilean::monitor
