// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/command/about.h"

#include <sys/utsname.h>

#include "core/account.h"

namespace galilean::monitor {

std::string host_name() {
  utsname system{};
  return uname(&system) == 0 ? system.nodename : "";
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
