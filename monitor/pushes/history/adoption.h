// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

struct sqlite3;

namespace galilean::monitor {

/// Takes a history over that is older than the chain: adds a row that says so, and then a row for
/// each push, reply and progress that it holds. A text that does not have the hash that it is kept
/// under is moved under the one that it has, and the row names both. Does nothing if there is a
/// chain, or nothing to take over. Throws std::runtime_error if the disk cannot be read or written.
/// Requires: a transaction is open.
void adopt_old_rows(sqlite3* database, std::int64_t now_ns);

}  // namespace galilean::monitor
