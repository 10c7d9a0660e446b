// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/disk_probe.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "core/private_file.h"

namespace galilean::monitor {

Result<void> DiskProbe::open() {
  if (descriptor_ != kNone) return {};
  const auto opened = open_private_file(file_, O_WRONLY);
  if (!opened) return opened.error();
  descriptor_ = opened.value();
  return {};
}

void DiskProbe::close() noexcept {
  if (descriptor_ != kNone) ::close(std::exchange(descriptor_, kNone));
}

Result<void> DiskProbe::write() {
  if (const auto opened = open(); !opened) return opened;
  constexpr std::size_t kSector_bytes = 512;
  std::array<char, kSector_bytes> bytes{};
  ++count_;
  std::memcpy(bytes.data(), &count_, sizeof count_);
  errno = 0;
  const auto written = pwrite(descriptor_, bytes.data(), bytes.size(), 0);
  if (written == static_cast<ssize_t>(bytes.size()) && fdatasync(descriptor_) == 0) return {};
  const Error why{file_.string() + " cannot be written: " +
                  (errno == 0 ? "the disk took a part of it" : std::strerror(errno))};
  close();  // what the disk makes of it next is found out with a new descriptor
  return why;
}

}  // namespace galilean::monitor
