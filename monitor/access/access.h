// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "monitor/access/tokens.h"

namespace galilean::monitor {

enum class Right { kNone, kRead, kOperate };

/// Who may do what: the operator's token lets its bearer read and steer, the viewer's read. Where
/// nobody but this machine's users can reach the monitor, reading needs no token.
class Access {
 public:
  Access(Tokens tokens, bool reads_freely)
      : tokens_(std::move(tokens)), reads_freely_(reads_freely) {}

  /// Takes as long for a wrong token as for a right one.
  [[nodiscard]] Right right_of(std::string_view token) const noexcept;

 private:
  Tokens tokens_;
  bool reads_freely_;
};

/// Returns whether an address can be reached from this machine only.
[[nodiscard]] bool is_loopback(const std::string& address);

/// What to tell those who may not, and what they can do about it.
[[nodiscard]] std::string missing_right(Right needed);

}  // namespace galilean::monitor
