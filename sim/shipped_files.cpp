#include "sim/shipped_files.h"

namespace galilean::sim {

namespace fs = std::filesystem;

fs::path shipped_folder(const std::string& room, const fs::path& source) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share/galilean" / room;
  return !error && fs::is_directory(installed, error) ? installed : source;
}

fs::path find_shipped(const std::string& name_or_path, const std::string& room,
                      const fs::path& source, const std::string& extension) {
  const fs::path path = name_or_path;
  std::error_code error;
  if (path.has_parent_path() || fs::exists(path, error)) return path;
  fs::path shipped = shipped_folder(room, source) / path;
  if (shipped.extension() != extension) shipped += extension;
  return fs::exists(shipped, error) || path.extension() != extension ? shipped : path;
}

}  // namespace galilean::sim
