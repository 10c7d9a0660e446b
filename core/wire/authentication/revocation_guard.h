// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dds/security/dds_security_api_authentication.h>

#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/wire/authentication/revoked_list.h"

namespace galilean::wire {

/// Knows who is revoked, and the handles by which Cyclone knows those whom it let in. Any thread
/// may call its functions.
class RevocationGuard {
 public:
  /// Requires: `cyclone` outlives this object.
  explicit RevocationGuard(dds_security_authentication& cyclone)
      : original(cyclone), cyclone_(cyclone) {}

  /// Learns which files count. Reads the list at once, so that nobody is let in before.
  void use_files_of(const DDS_Security_Qos& qos);
  /// From now on reads the list every second, and has Cyclone forget who is in it. A null
  /// `listener` ends that.
  void set_listener(const dds_security_authentication_listener* listener);

  /// Notes the handle of this program's own identity.
  void note_own(DDS_Security_IdentityHandle handle);
  /// Has Cyclone forget whose certificate has expired, unless it is this program's own: Cyclone
  /// would delete the participant, with which the program goes on to work, and the others part with
  /// it by themselves.
  void expire(DDS_Security_IdentityHandle handle);

  /// Notes the subject of the identity CA that vouches for this program.
  void note_own_authority(std::string_view subject);
  /// Returns whether another CA is said to vouch for a program. Nobody may be let in because it
  /// returns false.
  [[nodiscard]] bool is_of_another_team(std::string_view authority) const;

  [[nodiscard]] bool is_revoked(const SubjectPrefix& prefix) const;

  /// Notes whose handle this is. One handle may be noted more than once.
  void note(const SubjectPrefix& prefix, DDS_Security_IdentityHandle handle);
  /// Forgets a handle that Cyclone uses no more.
  void forget(DDS_Security_IdentityHandle handle);

  /// Notes with whom a handshake is, whose certificate comes later.
  void begin(DDS_Security_HandshakeHandle handshake, DDS_Security_IdentityHandle with);
  void end(DDS_Security_HandshakeHandle handshake);
  /// Returns with whom it is, or DDS_SECURITY_HANDLE_NIL.
  [[nodiscard]] DDS_Security_IdentityHandle partner(DDS_Security_HandshakeHandle handshake) const;

  /// Cyclone's functions, before they were replaced.
  const dds_security_authentication original;

 private:
  struct Peer {
    SubjectPrefix prefix;
    DDS_Security_IdentityHandle handle;
  };

  void watch(const std::stop_token& stop);
  /// Keeps the last list where the new one is not whole, or not from this CA.
  void read_list();
  /// Has Cyclone forget who is revoked, again and again until Cyclone has returned the handle: a
  /// participant that is just being let in gets its handle a moment after it was noted.
  void expel();

  dds_security_authentication& cyclone_;
  const dds_security_authentication_listener* listener_ = nullptr;
  mutable std::mutex mutex_;
  std::string list_file_, ca_file_;
  std::string own_authority_;
  RevokedMembers revoked_;
  std::vector<Peer> peers_;
  std::vector<DDS_Security_IdentityHandle> own_;
  std::map<DDS_Security_HandshakeHandle, DDS_Security_IdentityHandle> handshakes_;
  bool told_unreadable_ = false;
  std::jthread watch_;  // last member, so that it ends first
};

}  // namespace galilean::wire
