// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean::mcap {

/// Opens a pipe for writing, as soon as somebody reads it, which is waited for five seconds. To
/// wait for that in open() would take no signal where the program has blocked those that end it.
/// Returns -1, with the reason in errno, if nobody does.
[[nodiscard]] int open_output_pipe(const std::string& path);

/// Opens a file for writing, and leaves what it holds. `made` tells whether it was not there.
/// Returns -1, with the reason in errno: EEXIST if it is there and may not be.
[[nodiscard]] int open_output_file(const std::string& path, bool may_be_there, bool& made);

/// Locks a file, which tells readers, too, that it is being written. Those look at the lock for a
/// moment, which is waited for. Returns false if another program writes the file. Where the disk
/// knows no locks, nobody is told.
[[nodiscard]] bool lock_output(int descriptor);

}  // namespace galilean::mcap
