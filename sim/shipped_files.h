#pragma once

#include <filesystem>
#include <string>

namespace galilean::sim {

/// The folder of files that ship: ../share/galilean/<room> beside the program's own folder, and
/// where that is not there, `source`.
[[nodiscard]] std::filesystem::path shipped_folder(const std::string& room,
                                                   const std::filesystem::path& source);

/// A bare name ("office") is a file that ships; anything with a folder or the extension is a path.
[[nodiscard]] std::filesystem::path find_shipped(const std::string& name_or_path,
                                                 const std::string& room,
                                                 const std::filesystem::path& source,
                                                 const std::string& extension);

}  // namespace galilean::sim
