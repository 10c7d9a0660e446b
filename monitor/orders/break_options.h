// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/command_line/command_line.h"
#include "core/result.h"
#include "core/wire/messages.h"
#include "monitor/orders/order_session.h"

namespace galilean::monitor {

/// The options of `galilean break`.
struct BreakOptions {
  Addressees whom;
  std::string key_file;  ///< empty: the operator's key, if there is one
  std::vector<std::string> places;
  std::string let_through;
  bool stop_team = false;
  bool lock = false;
  bool remove = false;
  bool clear = false;
  bool list = false;
};

/// Requires: `options` lives until the command line is read.
void add_break_options(CommandLine& line, BreakOptions& options);

/// Returns the order that the options give, without whom and from whom. Requires: they do not ask
/// for the list. Errors: the options make no order, or name neither robots nor the team.
[[nodiscard]] Result<msg::BreakOrder> order_of(const BreakOptions& options);

}  // namespace galilean::monitor
