// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>

#include "core/result.h"

namespace galilean {

/// Returns what stands where a file is expected: "a folder", "a pipe", "a socket" or "a device".
/// Returns an empty text for a regular file. `mode` is that of stat().
[[nodiscard]] std::string what_is_no_file(mode_t mode);

/// Opens a regular file for reading. It never waits, as opening a pipe without a writer would, and
/// never touches a device. Returns the descriptor, which the caller closes.
/// Errors: it cannot be opened, or it is no regular file. The message is a reason that stands
/// behind "cannot be read: ", such as "it is a pipe, and no file".
[[nodiscard]] Result<int> open_regular_file(const std::string& path);

/// Reads a regular file whole.
/// Errors: as those of open_regular_file(), or it has more than `most_bytes` bytes.
[[nodiscard]] Result<std::string> read_regular_file(const std::string& path,
                                                    std::uintmax_t most_bytes);

}  // namespace galilean
