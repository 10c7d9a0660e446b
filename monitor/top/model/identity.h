// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace galilean::monitor::top {

/// A robot's letter and the number of its colour, which are those of the page.
struct Identity {
  std::size_t number = 0;
  std::string letter = "?";  ///< one character, or more where letters are short

  bool operator==(const Identity&) const = default;
};

/// Returns the identity of a robot that joins others. The paper's three robots keep theirs however
/// late they come. web/src/model/identity.ts does the same for the page.
[[nodiscard]] Identity identity_of(const std::string& name, const std::vector<Identity>& others);

/// The identities of all robots that were heard, in the order in which they were heard.
class Identities {
 public:
  void meet(const std::string& robot);
  void forget(const std::string& robot) { by_name_.erase(robot); }
  [[nodiscard]] std::size_t count() const noexcept { return by_name_.size(); }
  /// Returns the robot's identity, or "?" if it was never met.
  [[nodiscard]] const Identity& of(const std::string& robot) const;

 private:
  std::map<std::string, Identity> by_name_;
};

}  // namespace galilean::monitor::top
