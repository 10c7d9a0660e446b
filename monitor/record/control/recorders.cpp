// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/control/recorders.h"

#include <utility>

#include "core/visible_text.h"

namespace galilean::monitor {

void Recorders::note(RecorderStatus status, Time now) {
  const std::string name = status.name;
  heard_[name] = {std::move(status), now};
}

Result<const RecorderStatus*> Recorders::find(const std::string& name, Time now) const {
  std::string names;
  const RecorderStatus* found = nullptr;
  std::size_t live = 0;
  for (const auto& [each, heard] : heard_) {
    if (now - heard.at > kSilentAfter) continue;
    if (each == name) return &heard.status;
    names += (names.empty() ? "" : ", ") + visible(each);
    found = &heard.status;
    ++live;
  }
  if (live == 0)
    return Error{
        "no recorder is heard; check that galilean record runs in the same DDS domain (--domain or "
        "ROS_DOMAIN_ID)"};
  if (!name.empty())
    return Error{"the recorder '" + visible(name) + "' is not heard; heard " +
                 (live == 1 ? "is " : "are ") + names};
  if (live > 1)
    return Error{"several recorders are heard; choose one of them with --name: " + names};
  return found;
}

}  // namespace galilean::monitor
