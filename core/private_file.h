// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "core/result.h"

namespace galilean {

// What only its owner may read: secrets, logs that may tell them, and what people have done. Such
// files have the mode 0600 and the folders that are made for them 0700, whatever the umask is.

/// Opens a file for writing, and makes it if it is not there. Of a regular file that is there the
/// rights of others are taken, where the file system and its owner permit that. `flags` are those
/// of open(2), such as O_WRONLY | O_APPEND. Returns the descriptor, which the caller closes.
/// Errors: it cannot be opened. The sentence names the file.
[[nodiscard]] Result<int> open_private_file(const std::filesystem::path& file, int flags);

/// Takes the rights of others from a regular file that is there. It does not open the file, because
/// closing it again would end the locks that this process has on it.
void take_from_others(const std::filesystem::path& file) noexcept;

/// Writes all of `text`. Returns false if not all could be written; errno says why.
[[nodiscard]] bool write_all(int descriptor, std::string_view text) noexcept;

/// Replaces a file by one that holds `text`, or leaves it as it is. A reader, or a crash at any
/// moment, finds the old text or the new one.
/// Errors: nothing can be written there. The sentence names the file.
[[nodiscard]] Result<void> replace_private_file(const std::filesystem::path& file,
                                                std::string_view text);

/// Makes the folder and those above it that are missing. Folders that are there stay as they are,
/// because they may be shared on purpose.
/// Errors: it cannot be made. The sentence names the folder.
[[nodiscard]] Result<void> make_private_folder(const std::filesystem::path& folder);

}  // namespace galilean
