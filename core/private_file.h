// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

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

/// Writes a file that is not there yet, whole or not at all, so that a crash never leaves half a
/// secret. One that is there stays as it is, which is no error: another process was quicker. `mode`
/// is the file's, whatever the umask is. Errors: it cannot be written. The sentence names the file.
[[nodiscard]] Result<void> write_new_file(const std::filesystem::path& file, std::string_view text,
                                          mode_t mode);

/// Has the disk keep the names in a folder, so that a change of them outlasts a loss of power. A
/// folder that cannot be synced has them at once all the same.
void sync_folder(const std::filesystem::path& folder) noexcept;

/// Makes the folder and those above it that are missing. Folders that are there stay as they are,
/// because they may be shared on purpose.
/// Errors: it cannot be made. The sentence names the folder.
[[nodiscard]] Result<void> make_private_folder(const std::filesystem::path& folder);

}  // namespace galilean
