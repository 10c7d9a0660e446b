// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace galilean {

/// Returns the folder of the running executable, where the other programs are too. Returns the
/// current folder if the system does not tell.
[[nodiscard]] std::filesystem::path program_folder();

/// Returns the path of a file or folder that is installed with the programs:
/// ../share/galilean/<name>, seen from their folder.
[[nodiscard]] std::filesystem::path shipped(const std::string& name);

/// Finds a file that a person named. A bare name ("office") that is no file in the current folder
/// means the installed file of that name in the folder `room`. Anything else is a path. The result
/// need not exist.
[[nodiscard]] std::filesystem::path find_file(const std::string& name_or_path,
                                              const std::string& room,
                                              const std::string& extension);

}  // namespace galilean
