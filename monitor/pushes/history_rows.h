// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "core/wire/messages.h"
#include "monitor/pushes/push_record.h"
#include "monitor/pushes/sql.h"

namespace galilean::monitor::rows {

// How pushes stand in the history's tables. All throw std::runtime_error where the disk refuses.

/// Makes the tables where they are missing. What was running when its monitor ended is from now on
/// interrupted.
void create_tables(sqlite3* database);

void put_files(sqlite3* database, const msg::ProgramPush& push);
void put_push(sqlite3* database, const msg::ProgramPush& push);
void put_progress(sqlite3* database, const std::string& push_id, const Progress& progress);
void put_reply(sqlite3* database, const std::string& push_id, const RobotReply& reply);

/// Returns a question for pushes, which goes on with `condition`: its parameters are yet to be
/// bound.
[[nodiscard]] sql::Statement select_pushes(sqlite3* database, const std::string& condition);
[[nodiscard]] std::vector<PushRecord> records_of(sqlite3* database, sql::Statement& rows);
/// Returns the first row's; nothing if there is none.
[[nodiscard]] std::optional<PushRecord> record_of(sqlite3* database, sql::Statement& rows);

/// Returns the files of the one program whose hash begins so; nothing if none or several do.
[[nodiscard]] std::optional<std::vector<bhdl::SourceFile>> files_of(sqlite3* database,
                                                                    const std::string& hash);

}  // namespace galilean::monitor::rows
