#include "front/siblings.h"

#include <unistd.h>

#include <filesystem>

namespace galilean::front {

std::string sibling(std::string_view program) {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return (error ? std::filesystem::path(program) : self.parent_path() / program).string();
}

bool is_program(const std::string& path) {
  return access(path.c_str(), X_OK) == 0;
}

}  // namespace galilean::front
