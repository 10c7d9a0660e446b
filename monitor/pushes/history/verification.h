// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/result.h"

struct sqlite3;

namespace galilean::monitor {

/// The first row of a history that is not as it was written.
struct BrokenRow {
  std::int64_t number = 0;   ///< its number in the chain; 0: the chain has no row of it
  std::int64_t time_ns = 0;  ///< when it was written, since the Unix epoch; 0: not known
  std::string what;          ///< what differs, in a clause
};

/// The result of a verification.
struct Verification {
  std::int64_t rows = 0;  ///< of the chain
  std::string head;       ///< the hash of its last row; empty: it has none
  std::optional<BrokenRow> broken = {};
};

/// Checks that each row of the chain has the hash of its content and of the row before it, that
/// none is missing, that the tables of pushes hold what the chain tells last, and that each
/// program's text has its hash. Whoever can write the file can make a whole chain anew: what was
/// noted of `head` elsewhere shows that. Errors: the file cannot be read, or is no history.
[[nodiscard]] Result<Verification> verify(sqlite3* database);
/// As above, of a file that is only read. If `noted` is not empty, a row whose hash begins with it
/// must be there: it is the head that an earlier verification told, so that it shows whether rows
/// were taken away from the end. Errors: also if it has no chain yet.
[[nodiscard]] Result<Verification> verify_history(const std::filesystem::path& file,
                                                  const std::string& noted = {});

/// Returns one sentence.
[[nodiscard]] std::string in_words(const Verification& verification);

}  // namespace galilean::monitor
