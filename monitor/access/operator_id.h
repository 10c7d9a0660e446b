// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace galilean::monitor {

/// Who steers, as other operators are told. One person may steer from several tabs and processes.
struct OperatorId {
  std::string name;     ///< as it is shown
  std::string account;  ///< the name of the token that was sent: "operator" for operator.token
  std::string client;   ///< the tab or process; empty if it did not say, or if several are meant

  [[nodiscard]] bool is_same_person(const OperatorId& other) const noexcept {
    return name == other.name && account == other.account;
  }
  bool operator==(const OperatorId&) const = default;
};

inline constexpr std::size_t kMostOperatorBytes = 64;  ///< of a name and of a client's id

/// Returns who sent a request. `name` and `client` are what it says of itself; what is longer than
/// kMostOperatorBytes is cut, and what cannot be shown is escaped. Without a name it is called by
/// its token, if that has a person's name. Else it is the user whose monitor this is if it comes
/// from this machine, because only that user can read operator.token, and else its address.
[[nodiscard]] OperatorId operator_id(std::string_view name, std::string_view client,
                                     const std::string& account, const std::string& address);

}  // namespace galilean::monitor
