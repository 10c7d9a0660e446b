// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"

namespace galilean {

/// Returns whether two paths name one file: by other spellings, through symbolic links, or as hard
/// links. The file need not be there yet. An empty path names none.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

/// Checks the files that a command is asked to write, before it opens any. Empty paths are passed
/// over. So are pipes and devices, in which nothing can be lost.
/// Errors: the command reads one of them, too, or would write one of them twice; or one is "-", by
/// which people mean standard output.
[[nodiscard]] Result<void> check_written_files(const std::vector<std::string>& written,
                                               const std::vector<std::string>& read);

/// Removes a file whose writing failed, as on a full disk: the part that is there would pass for
/// the whole, or for an empty result. Leaves pipes and devices.
void remove_unfinished(const std::string& path) noexcept;

}  // namespace galilean
