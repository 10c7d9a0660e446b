// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/refusals.h"

#include "core/visible_text.h"

namespace galilean::wire {
namespace {

using Kind = std::pair<std::string, std::string>;

const Kind& other_kinds() {
  static const Kind kKind{Refusals::kOthers, "more topics and reasons than are told apart"};
  return kKind;
}

}  // namespace

void Refusals::note(const std::string& topic, std::string_view reason) {
  const Kind kind(topic, reason);
  if (count(kind) && tell_)
    tell_("a message on " + visible(topic) + " was ignored: " + kind.second +
          " (more of this kind are only counted)");
}

bool Refusals::count(const Kind& kind) {
  const std::lock_guard lock(mutex_);
  if (const auto known = counts_.find(kind); known != counts_.end()) {
    ++known->second;
    return false;
  }
  const bool has_room = counts_.size() < kMostKinds;
  ++counts_[has_room ? kind : other_kinds()];
  return has_room;
}

std::vector<Refusals::Count> Refusals::counts() const {
  const std::lock_guard lock(mutex_);
  std::vector<Count> list;
  for (const auto& [kind, messages] : counts_) list.push_back({kind.first, kind.second, messages});
  return list;
}

}  // namespace galilean::wire
