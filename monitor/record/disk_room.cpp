// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/disk_room.h"

#include <filesystem>
#include <system_error>

namespace galilean::monitor {

std::optional<std::uint64_t> free_bytes(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code unknown;
  if (fs::is_other(path, unknown)) return std::nullopt;  // a pipe or a device fills no disk
  const auto folder = fs::absolute(path, unknown).parent_path();
  const auto space = fs::space(folder, unknown);
  if (unknown) return std::nullopt;
  return space.available;
}

bool DiskRoom::look() {
  if (least_bytes_ == 0) return true;
  const auto free = ask_();
  if (!free) return has_room_;
  free_ = *free;
  const std::uint64_t wanted = has_room_ ? least_bytes_ : least_bytes_ + least_bytes_ / 4;
  return has_room_ = free_ >= wanted;
}

}  // namespace galilean::monitor
