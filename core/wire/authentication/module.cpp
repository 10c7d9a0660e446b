// SPDX-License-Identifier: BSD-3-Clause
// Cyclone's authentication, with one question more: is the member revoked? Cyclone 0.10 reads the
// list of revoked certificates once, when a program joins. This module reads it every second,
// refuses who is in it, and has Cyclone forget who was let in before. It also keeps Cyclone from
// deleting the participant of a program whose own keys expire, and refuses programs of other teams
// before the handshake, of which only one side would learn the reason.
#include <dds/ddsrt/dynlib.h>
#include <dds/ddsrt/retcode.h>
#include <dds/security/dds_security_api_authentication.h>
#include <dds/security/dds_security_api_err.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/wire/authentication/identity_token.h"
#include "core/wire/authentication/revocation_guard.h"

// Of dds_security_utils.h, which C++ cannot read.
extern "C" void DDS_Security_Exception_set(DDS_Security_SecurityException* exception,
                                           const char* context, int code, int minor_code,
                                           const char* format, ...);

namespace galilean::wire {
namespace {

constexpr const char* kLibrary = "dds_security_auth";

/// Returns the prefix of the member whose certificate is in a message of the handshake. A program
/// that is not Cyclone's may announce another GUID than that of its certificate.
std::optional<SubjectPrefix> prefix_in(const DDS_Security_HandshakeMessageToken* message) {
  if (!message) return {};
  const auto& properties = message->binary_properties;
  for (std::uint32_t i = 0; i < properties._length; ++i) {
    const auto& property = properties._buffer[i];
    if (property.name && std::string_view(property.name) == "c.id" && property.value._buffer)
      return prefix_of_certificate({property.value._buffer, property.value._length});
  }
  return {};
}

SubjectPrefix prefix_of(const DDS_Security_GUID_t& guid) {
  SubjectPrefix prefix{};
  std::copy_n(guid.prefix, prefix.size(), prefix.begin());
  return prefix;
}

/// One instance of Cyclone's a domain, with what this module adds to it.
struct Loaded {
  ddsrt_dynlib_t library = nullptr;
  std::unique_ptr<RevocationGuard> guard;
};
std::mutex loaded_mutex;
std::map<void*, Loaded> loaded;

RevocationGuard& guard_of(const void* instance) {
  const std::lock_guard lock(loaded_mutex);
  return *loaded.at(const_cast<void*>(instance)).guard;
}

DDS_Security_ValidationResult_t validate_local(
    dds_security_authentication* instance, DDS_Security_IdentityHandle* handle,
    DDS_Security_GUID_t* adjusted, const DDS_Security_DomainId domain, const DDS_Security_Qos* qos,
    const DDS_Security_GUID_t* candidate, DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  if (qos) guard.use_files_of(*qos);
  const auto result = guard.original.validate_local_identity(instance, handle, adjusted, domain,
                                                             qos, candidate, problem);
  if (handle && result == DDS_SECURITY_VALIDATION_OK) guard.note_own(*handle);
  return result;
}

DDS_Security_ValidationResult_t refuse(const SubjectPrefix& id,
                                       DDS_Security_SecurityException* problem) {
  DDS_Security_Exception_set(
      problem, "Authentication", DDS_SECURITY_ERR_UNDEFINED_CODE, DDS_SECURITY_VALIDATION_FAILED,
      "the member %02x%02x%02x%02x%02x%02x is revoked", id[0], id[1], id[2], id[3], id[4], id[5]);
  return DDS_SECURITY_VALIDATION_FAILED;
}

/// Refuses whose certificate another CA is said to have signed. The handshake would do so, too, but
/// the side that begins it would only wait for an answer that never comes.
DDS_Security_ValidationResult_t refuse_other_team(const DDS_Security_IdentityToken& token,
                                                  DDS_Security_SecurityException* problem) {
  constexpr std::size_t kMostShown = 200;
  const std::string subject(subject_in(token).substr(0, kMostShown));
  const std::string authority(authority_in(token).substr(0, kMostShown));
  DDS_Security_Exception_set(problem, "Authentication", DDS_SECURITY_ERR_UNDEFINED_CODE,
                             DDS_SECURITY_VALIDATION_FAILED,
                             "another identity CA vouches for the certificate: %s; subject: %s",
                             authority.c_str(), subject.c_str());
  return DDS_SECURITY_VALIDATION_FAILED;
}

/// Is called when this program joins, with what it will announce.
DDS_Security_boolean tell_identity(dds_security_authentication* instance,
                                   DDS_Security_IdentityToken* token,
                                   const DDS_Security_IdentityHandle handle,
                                   DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  const auto told = guard.original.get_identity_token(instance, token, handle, problem);
  if (told && token) guard.note_own_authority(authority_in(*token));
  return told;
}

DDS_Security_ValidationResult_t validate_remote(
    dds_security_authentication* instance, DDS_Security_IdentityHandle* handle,
    DDS_Security_AuthRequestMessageToken* local_request,
    const DDS_Security_AuthRequestMessageToken* remote_request,
    const DDS_Security_IdentityHandle local, const DDS_Security_IdentityToken* token,
    const DDS_Security_GUID_t* guid, DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  if (guid && guard.is_revoked(prefix_of(*guid))) return refuse(prefix_of(*guid), problem);
  if (token && guard.is_of_another_team(authority_in(*token)))
    return refuse_other_team(*token, problem);
  const auto result = guard.original.validate_remote_identity(
      instance, handle, local_request, remote_request, local, token, guid, problem);
  if (guid && handle && result != DDS_SECURITY_VALIDATION_FAILED)
    guard.note(prefix_of(*guid), *handle);
  return result;
}

DDS_Security_ValidationResult_t begin_request(dds_security_authentication* instance,
                                              DDS_Security_HandshakeHandle* handshake,
                                              DDS_Security_HandshakeMessageToken* sent,
                                              const DDS_Security_IdentityHandle own,
                                              const DDS_Security_IdentityHandle remote,
                                              const DDS_Security_OctetSeq* data,
                                              DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  const auto result =
      guard.original.begin_handshake_request(instance, handshake, sent, own, remote, data, problem);
  if (handshake && result != DDS_SECURITY_VALIDATION_FAILED) guard.begin(*handshake, remote);
  return result;
}

DDS_Security_ValidationResult_t begin_reply(
    dds_security_authentication* instance, DDS_Security_HandshakeHandle* handshake,
    DDS_Security_HandshakeMessageToken* sent, const DDS_Security_HandshakeMessageToken* received,
    const DDS_Security_IdentityHandle remote, const DDS_Security_IdentityHandle own,
    const DDS_Security_OctetSeq* data, DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  const auto prefix = prefix_in(received);
  if (prefix && guard.is_revoked(*prefix)) return refuse(*prefix, problem);
  if (prefix) guard.note(*prefix, remote);
  return guard.original.begin_handshake_reply(instance, handshake, sent, received, remote, own,
                                              data, problem);
}

DDS_Security_ValidationResult_t process(dds_security_authentication* instance,
                                        DDS_Security_HandshakeMessageToken* sent,
                                        const DDS_Security_HandshakeMessageToken* received,
                                        const DDS_Security_HandshakeHandle handshake,
                                        DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  const auto prefix = prefix_in(received);
  if (prefix && guard.is_revoked(*prefix)) return refuse(*prefix, problem);
  const auto remote = guard.partner(handshake);
  if (prefix && remote != DDS_SECURITY_HANDLE_NIL) guard.note(*prefix, remote);
  return guard.original.process_handshake(instance, sent, received, handshake, problem);
}

DDS_Security_boolean return_handshake(dds_security_authentication* instance,
                                      const DDS_Security_HandshakeHandle handshake,
                                      DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  guard.end(handshake);
  return guard.original.return_handshake_handle(instance, handshake, problem);
}

DDS_Security_boolean return_identity(dds_security_authentication* instance,
                                     const DDS_Security_IdentityHandle handle,
                                     DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  guard.forget(handle);
  return guard.original.return_identity_handle(instance, handle, problem);
}

/// Is called by Cyclone's plugin when a certificate expires.
DDS_Security_boolean expired(const dds_security_authentication* instance,
                             const DDS_Security_IdentityHandle handle) {
  RevocationGuard* guard = nullptr;
  {
    const std::lock_guard lock(loaded_mutex);
    const auto found = loaded.find(const_cast<dds_security_authentication*>(instance));
    if (found == loaded.end()) return true;  // it ends, and waits for this thread
    guard = found->second.guard.get();
  }
  guard->expire(handle);
  return true;
}
constexpr dds_security_authentication_listener kExpiryListener{expired, nullptr};

DDS_Security_boolean listen(dds_security_authentication* instance,
                            const dds_security_authentication_listener* listener,
                            DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  guard.set_listener(listener);
  return guard.original.set_listener(instance, listener ? &kExpiryListener : nullptr, problem);
}

void* function_in(ddsrt_dynlib_t library, const char* name) {
  void* function = nullptr;
  return ddsrt_dlsym(library, name, &function) == DDS_RETCODE_OK ? function : nullptr;
}

using Initialise = int (*)(const char*, void**, ddsi_domaingv*);
using Finalise = int (*)(void*);

}  // namespace
}  // namespace galilean::wire

extern "C" {

__attribute__((visibility("default"))) int galilean_init_authentication(const char* argument,
                                                                        void** context,
                                                                        ddsi_domaingv* domain) {
  using namespace galilean::wire;
  Loaded made;
  if (ddsrt_dlopen(kLibrary, true, &made.library) != DDS_RETCODE_OK) return DDS_RETCODE_ERROR;
  const auto initialise =
      reinterpret_cast<Initialise>(function_in(made.library, "init_authentication"));
  if (!initialise || initialise(argument, context, domain) != DDS_RETCODE_OK) {
    static_cast<void>(ddsrt_dlclose(made.library));
    return DDS_RETCODE_ERROR;
  }
  auto* cyclone = static_cast<dds_security_authentication*>(*context);
  made.guard = std::make_unique<RevocationGuard>(*cyclone);
  cyclone->validate_local_identity = validate_local;
  cyclone->get_identity_token = tell_identity;
  cyclone->validate_remote_identity = validate_remote;
  cyclone->begin_handshake_request = begin_request;
  cyclone->begin_handshake_reply = begin_reply;
  cyclone->process_handshake = process;
  cyclone->return_handshake_handle = return_handshake;
  cyclone->return_identity_handle = return_identity;
  cyclone->set_listener = listen;
  const std::lock_guard lock(loaded_mutex);
  loaded[*context] = std::move(made);
  return DDS_RETCODE_OK;
}

__attribute__((visibility("default"))) int galilean_finalize_authentication(void* context) {
  using namespace galilean::wire;
  Loaded ended;
  {
    const std::lock_guard lock(loaded_mutex);
    const auto found = loaded.find(context);
    if (found == loaded.end()) return DDS_RETCODE_ERROR;
    ended = std::move(found->second);
    loaded.erase(found);
  }
  ended.guard->set_listener(nullptr);  // its thread ends before what it calls
  const auto finalise =
      reinterpret_cast<Finalise>(function_in(ended.library, "finalize_authentication"));
  const int result = finalise ? finalise(context) : DDS_RETCODE_ERROR;
  static_cast<void>(ddsrt_dlclose(ended.library));
  return result;
}

}  // extern "C"
