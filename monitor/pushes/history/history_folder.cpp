// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/history_folder.h"

#include <string>

namespace galilean::monitor {

std::filesystem::path history_folder(const std::filesystem::path& data_folder, std::uint32_t domain,
                                     std::uint16_t port) {
  constexpr std::uint32_t kUsualDomain = 0;
  constexpr std::uint16_t kUsualPort = 8080;
  if (domain == kUsualDomain && port == kUsualPort) return data_folder;
  return data_folder / "histories" /
         ("domain-" + std::to_string(domain) + "-port-" + std::to_string(port));
}

}  // namespace galilean::monitor
