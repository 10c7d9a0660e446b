// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "monitor/pushes/history/sql.h"

namespace galilean::monitor::rows {

/// A row of a table as the chain holds it.
struct Told {
  std::string subject;  ///< the push's id
  std::string robot;    ///< of a reply; else empty
  nlohmann::json content;
};
/// Returns the rows of kind chain::kPush, kReply or kProgress of a push; without an id, those of
/// all pushes: pushes in their order, and the others in the order of the pushes' ids.
[[nodiscard]] std::vector<Told> told(sqlite3* database, const char* kind,
                                     const std::optional<std::string>& push_id = {});

}  // namespace galilean::monitor::rows
