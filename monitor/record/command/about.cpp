// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/command/about.h"

#include <sys/utsname.h>

#include <algorithm>
#include <array>

#include "core/account.h"

namespace galilean::monitor {

std::string host_name() {
  utsname system{};
  return uname(&system) == 0 ? system.nodename : "";
}

bool is_told_anyway(std::string_view word) noexcept {
  // Those of `about`, and those that the recorder adds to each file.
  constexpr std::array<std::string_view, 10> kTold{"system", "version", "compiler", "host",
                                                   "user",   "name",    "domain",   "started",
                                                   "file",   "event"};
  return std::ranges::find(kTold, word) != kTold.end();
}

mcap::Text about(const RecordingOptions& options, std::uint32_t domain) {
  mcap::Text text = options.about;
  utsname system{};
  if (uname(&system) == 0)
    text["system"] = std::string(system.sysname) + ' ' + system.release + ' ' + system.machine;
  text["version"] = GALILEAN_VERSION;
  text["compiler"] = __VERSION__;
  text["host"] = host_name();
  text["user"] = user_name();
  text["name"] = options.name;
  text["domain"] = std::to_string(domain);
  return text;
}

}  // namespace galilean::monitor
