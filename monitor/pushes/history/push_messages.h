// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "core/wire/messages.h"
#include "monitor/pushes/history/push_record.h"

namespace galilean::monitor {

/// Returns a random id for a push or a command, which no other has.
[[nodiscard]] std::string new_id();

/// Returns the hash that the push's files have, whatever hash it announces; empty if it has none.
[[nodiscard]] std::string hash_of_files(const msg::ProgramPush& push);

/// Returns the message that pushes a checked program, with a new id.
[[nodiscard]] msg::ProgramPush make_push(const bhdl::Program& program, const std::string& author,
                                         const std::vector<std::string>& targets,
                                         const std::string& replaces_hash = {});
/// Returns the message that says how far a push is, stamped now.
[[nodiscard]] msg::PushProgress progress_message(const PushRecord& push);

}  // namespace galilean::monitor
