// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/authentication/revocation_guard.h"

#include <dds/ddsrt/heap.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <iostream>
#include <string_view>
#include <utility>

// Of dds_security_utils.h, which C++ cannot read.
extern "C" char* DDS_Security_Property_get_value(const DDS_Security_PropertySeq* properties,
                                                 const char* name);

namespace galilean::wire {
namespace {

constexpr std::chrono::seconds kReadAgain{1};

/// Returns the path in a property such as "file:/a/b.pem", or an empty text.
std::string path_in(const DDS_Security_Qos& qos, const char* property) {
  constexpr std::string_view kFile = "file:";
  char* value = DDS_Security_Property_get_value(&qos.property.value, property);
  const std::string text = value ? value : "";
  ddsrt_free(value);
  return text.starts_with(kFile) ? text.substr(kFile.size()) : std::string();
}

}  // namespace

void RevocationGuard::use_files_of(const DDS_Security_Qos& qos) {
  {
    const std::lock_guard lock(mutex_);
    list_file_ = path_in(qos, "org.eclipse.cyclonedds.sec.auth.crl");
    ca_file_ = path_in(qos, "dds.sec.auth.identity_ca");
  }
  read_list();
}

void RevocationGuard::set_listener(const dds_security_authentication_listener* listener) {
  watch_ = std::jthread();  // the thread that may still call the old one ends first
  {
    const std::lock_guard lock(mutex_);
    listener_ = listener;
  }
  if (listener) watch_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

void RevocationGuard::note_own(DDS_Security_IdentityHandle handle) {
  const std::lock_guard lock(mutex_);
  own_.push_back(handle);
}

void RevocationGuard::expire(DDS_Security_IdentityHandle handle) {
  bool is_own = false;
  const dds_security_authentication_listener* listener = nullptr;
  {
    const std::lock_guard lock(mutex_);
    is_own = std::find(own_.begin(), own_.end(), handle) != own_.end();
    listener = listener_;
  }
  if (is_own)
    std::cerr
        << "galilean: DDS Security: the keys of this program have expired, and the team parts "
           "with it; 'galilean team keys renew' renews them: copy them, and start it again\n";
  else if (listener)
    listener->on_revoke_identity(&cyclone_, handle);
}

void RevocationGuard::note_own_authority(std::string_view subject) {
  const std::lock_guard lock(mutex_);
  own_authority_ = subject;
}

bool RevocationGuard::is_of_another_team(std::string_view authority) const {
  const std::lock_guard lock(mutex_);
  return !authority.empty() && !own_authority_.empty() && authority != own_authority_;
}

bool RevocationGuard::is_revoked(const SubjectPrefix& prefix) const {
  const std::lock_guard lock(mutex_);
  return revoked_.contains(prefix);
}

void RevocationGuard::note(const SubjectPrefix& prefix, DDS_Security_IdentityHandle handle) {
  const std::lock_guard lock(mutex_);
  const auto same = [&](const Peer& peer) {
    return peer.handle == handle && peer.prefix == prefix;
  };
  if (std::none_of(peers_.begin(), peers_.end(), same)) peers_.push_back({prefix, handle});
}

void RevocationGuard::forget(DDS_Security_IdentityHandle handle) {
  const std::lock_guard lock(mutex_);
  std::erase_if(peers_, [&](const Peer& peer) { return peer.handle == handle; });
  std::erase(own_, handle);
}

void RevocationGuard::begin(DDS_Security_HandshakeHandle handshake,
                            DDS_Security_IdentityHandle with) {
  const std::lock_guard lock(mutex_);
  handshakes_[handshake] = with;
}

void RevocationGuard::end(DDS_Security_HandshakeHandle handshake) {
  const std::lock_guard lock(mutex_);
  handshakes_.erase(handshake);
}

DDS_Security_IdentityHandle RevocationGuard::partner(DDS_Security_HandshakeHandle handshake) const {
  const std::lock_guard lock(mutex_);
  const auto found = handshakes_.find(handshake);
  return found == handshakes_.end() ? DDS_SECURITY_HANDLE_NIL : found->second;
}

void RevocationGuard::watch(const std::stop_token& stop) {
  std::mutex sleeping;
  std::condition_variable_any never;
  while (!stop.stop_requested()) {
    read_list();
    expel();
    std::unique_lock lock(sleeping);
    never.wait_for(lock, stop, kReadAgain, [] { return false; });
  }
}

void RevocationGuard::read_list() {
  std::string list_file, ca_file;
  {
    const std::lock_guard lock(mutex_);
    list_file = list_file_;
    ca_file = ca_file_;
  }
  if (list_file.empty()) return;
  auto read = read_revoked(list_file, ca_file);
  const std::lock_guard lock(mutex_);
  if (!read && !told_unreadable_)
    std::cerr << "galilean: DDS Security: " << list_file
              << " is not a list of revoked members from this team's identity CA; copy the team's "
                 "revoked.crl there; until then the last list counts\n";
  told_unreadable_ = !read;
  if (read) revoked_ = std::move(*read);
}

void RevocationGuard::expel() {
  std::vector<DDS_Security_IdentityHandle> handles;
  const dds_security_authentication_listener* listener = nullptr;
  {
    const std::lock_guard lock(mutex_);
    listener = listener_;
    for (const auto& peer : peers_)
      if (revoked_.contains(peer.prefix)) handles.push_back(peer.handle);
  }
  if (!listener) return;
  // Cyclone calls this module in the meantime: no lock is held.
  for (const auto handle : handles) listener->on_revoke_identity(&cyclone_, handle);
}

}  // namespace galilean::wire
