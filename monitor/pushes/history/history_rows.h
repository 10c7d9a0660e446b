// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "core/wire/messages.h"
#include "monitor/pushes/history/push_record.h"
#include "monitor/pushes/history/sql.h"

namespace galilean::monitor::rows {

// Reads and writes the history's tables of pushes. They hold what the chain tells last, so that it
// is found fast: whoever changes one adds to the chain. All functions throw std::runtime_error if
// the disk cannot be read or written.

/// Makes the tables if they are missing, and numbers the pushes of a release that did not.
void create_tables(sqlite3* database);

/// Stores a text under the hash that it has, whatever hash `push` announces.
void put_files(sqlite3* database, const msg::ProgramPush& push);
/// Gives the push the next number of the monitor's own sequence, which is the order of pushes. A
/// sender's stamp is of a clock that nobody vouches for, and is kept for people. Returns false if
/// there is a push of this id, which is left as it is.
[[nodiscard]] bool put_push(sqlite3* database, const msg::ProgramPush& push);
void put_progress(sqlite3* database, const std::string& push_id, const Progress& progress);
void put_reply(sqlite3* database, const std::string& push_id, const RobotReply& reply);

/// Changes the state alone, whatever else the row holds.
void set_state(sqlite3* database, const std::string& push_id, PushState state);
/// Returns the ids of the pushes in this state.
[[nodiscard]] std::vector<std::string> in_state(sqlite3* database, PushState state);
/// Returns a query for pushes that ends with `condition`. The caller binds its parameters.
[[nodiscard]] sql::Statement select_pushes(sqlite3* database, const std::string& condition);
/// Of such a query's condition: the push was made through a monitor, or a robot took it.
inline constexpr const char* kBroughtIt =
    "(coalesce(state, 'done') <> '' OR EXISTS (SELECT 1 FROM answer WHERE answer.push_id = "
    "push.id AND status IN ('running', 'confirmed', 'rolled_back')))";
[[nodiscard]] std::vector<PushRecord> records_of(sqlite3* database, sql::Statement& rows);
/// Returns the push in the first row; nothing if there is no row.
[[nodiscard]] std::optional<PushRecord> record_of(sqlite3* database, sql::Statement& rows);

/// Returns the files of the program whose hash begins with `hash`; nothing if none does, or
/// several. Throws if they have another hash.
[[nodiscard]] std::optional<std::vector<bhdl::SourceFile>> files_of(sqlite3* database,
                                                                    const std::string& hash);

}  // namespace galilean::monitor::rows
