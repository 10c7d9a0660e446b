// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/open_sockets.h"

#include <utility>

namespace galilean::monitor {

void OpenSockets::add(std::string digest, Right right, std::weak_ptr<Revocable> session) {
  entries_.push_back({std::move(digest), right, std::move(session)});
}

bool OpenSockets::look_at(Entry& entry, const Access& access) {
  const auto session = entry.session.lock();
  if (!session) return false;
  if (entry.is_closing) {
    session->cut();
    return false;
  }
  if (access.right_by_digest(entry.digest) >= entry.right) return true;
  entry.is_closing = true;
  ++ended_;
  session->revoke("the token was revoked or has expired");
  return true;
}

void OpenSockets::end_withdrawn(const Access& access) {
  std::erase_if(entries_, [&](Entry& entry) { return !look_at(entry, access); });
}

}  // namespace galilean::monitor
