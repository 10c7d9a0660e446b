// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/history_folder.h"

#include <string>

#include "monitor/pushes/history/history_lock.h"

namespace galilean::monitor {

std::filesystem::path history_folder(const std::filesystem::path& data_folder, std::uint32_t domain,
                                     std::uint16_t port) {
  constexpr std::uint32_t kUsualDomain = 0;
  constexpr std::uint16_t kUsualPort = 8080;
  if (domain == kUsualDomain && port == kUsualPort) return data_folder;
  return data_folder / "histories" /
         ("domain-" + std::to_string(domain) + "-port-" + std::to_string(port));
}

std::filesystem::path history_file(const std::filesystem::path& data_folder, std::uint32_t domain,
                                   std::uint16_t port) {
  constexpr int kMostAtOnce = 64;
  const auto folder = history_folder(data_folder, domain, port);
  auto file = folder / kHistoryFile;
  // Of two monitors on one port the second finds that out by itself.
  for (int number = 2; port == 0 && number <= kMostAtOnce; ++number) {
    if (HistoryLock::take(lock_file_of(file))) break;
    file = folder.string() + "-" + std::to_string(number);
    file /= kHistoryFile;
  }
  return file;
}

}  // namespace galilean::monitor
