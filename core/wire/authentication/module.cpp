// SPDX-License-Identifier: BSD-3-Clause
// Cyclone's authentication, with one question more: is the member revoked? Cyclone 0.10 reads the
// list of revoked certificates once, when a program joins. This module reads it every second,
// refuses who is in it, and has Cyclone forget who was let in before.
#include <dds/ddsrt/dynlib.h>
#include <dds/ddsrt/heap.h>
#include <dds/security/dds_security_api_authentication.h>
#include <dds/security/dds_security_api_err.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "core/wire/authentication/revoked_list.h"

// Of dds_security_utils.h, which C++ cannot read.
extern "C" {
char* DDS_Security_Property_get_value(const DDS_Security_PropertySeq* properties, const char* name);
void DDS_Security_Exception_set(DDS_Security_SecurityException* exception, const char* context,
                                int code, int minor_code, const char* format, ...);
}

namespace galilean::wire {
namespace {

constexpr std::chrono::seconds kReadAgain{1};
constexpr const char* kLibrary = "dds_security_auth";
constexpr std::string_view kFile = "file:";

/// Returns the path in a property such as "file:/a/b.pem", or an empty text.
std::string path_in(const DDS_Security_Qos& qos, const char* property) {
  char* value = DDS_Security_Property_get_value(&qos.property.value, property);
  std::string text = value ? value : "";
  ddsrt_free(value);
  return text.starts_with(kFile) ? text.substr(kFile.size()) : std::string();
}

SubjectPrefix prefix_of(const DDS_Security_GUID_t& guid) {
  SubjectPrefix prefix{};
  std::copy_n(guid.prefix, prefix.size(), prefix.begin());
  return prefix;
}

/// What is added to one of Cyclone's instances.
class RevocationGuard {
 public:
  explicit RevocationGuard(dds_security_authentication& cyclone)
      : cyclone_(cyclone), original(cyclone) {}

  /// Learns which files count. Reads the list at once, so that nobody is let in before.
  void use_files_of(const DDS_Security_Qos& qos) {
    {
      const std::lock_guard lock(mutex_);
      list_file_ = path_in(qos, "org.eclipse.cyclonedds.sec.auth.crl");
      ca_file_ = path_in(qos, "dds.sec.auth.identity_ca");
    }
    read_list();
  }

  void set_listener(const dds_security_authentication_listener* listener) {
    watch_ = std::jthread();  // the thread that may still call the old one ends first
    listener_ = listener;
    if (listener_) watch_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
  }

  [[nodiscard]] bool is_revoked(const DDS_Security_GUID_t& guid) {
    const std::lock_guard lock(mutex_);
    return revoked_.contains(prefix_of(guid));
  }

  void note(const DDS_Security_GUID_t& guid, DDS_Security_IdentityHandle handle) {
    const std::lock_guard lock(mutex_);
    peers_.push_back({prefix_of(guid), handle});
  }

  void forget(DDS_Security_IdentityHandle handle) {
    const std::lock_guard lock(mutex_);
    const auto gone = std::find_if(peers_.begin(), peers_.end(),
                                   [&](const Peer& peer) { return peer.handle == handle; });
    if (gone != peers_.end()) peers_.erase(gone);
  }

 private:
  struct Peer {
    SubjectPrefix prefix;
    DDS_Security_IdentityHandle handle;
  };

  void watch(const std::stop_token& stop) {
    std::mutex sleeping;
    std::condition_variable_any never;
    while (!stop.stop_requested()) {
      read_list();
      expel();
      std::unique_lock lock(sleeping);
      never.wait_for(lock, stop, kReadAgain, [] { return false; });
    }
  }

  /// Keeps the last list where the new one is not whole, or not from this CA.
  void read_list() {
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
                << " is not a list of revoked members from this team's identity CA; copy the "
                   "team's revoked.crl there; until then the last list counts\n";
    told_unreadable_ = !read;
    if (read) revoked_ = std::move(*read);
  }

  /// Has Cyclone forget who is revoked, again and again until Cyclone has returned the handle: a
  /// participant that is just being let in gets its handle a moment after it was noted.
  void expel() {
    std::vector<DDS_Security_IdentityHandle> handles;
    {
      const std::lock_guard lock(mutex_);
      for (const auto& peer : peers_)
        if (revoked_.contains(peer.prefix)) handles.push_back(peer.handle);
    }
    // Cyclone calls this module in the meantime: no lock is held.
    for (const auto handle : handles) listener_->on_revoke_identity(&cyclone_, handle);
  }

  dds_security_authentication& cyclone_;

 public:
  const dds_security_authentication original;  ///< Cyclone's functions, before they were replaced

 private:
  const dds_security_authentication_listener* listener_ = nullptr;
  std::mutex mutex_;
  std::string list_file_, ca_file_;
  RevokedMembers revoked_;
  std::vector<Peer> peers_;
  bool told_unreadable_ = false;
  std::jthread watch_;  // last member, so that it ends first
};

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
  return guard.original.validate_local_identity(instance, handle, adjusted, domain, qos, candidate,
                                                problem);
}

DDS_Security_ValidationResult_t validate_remote(
    dds_security_authentication* instance, DDS_Security_IdentityHandle* handle,
    DDS_Security_AuthRequestMessageToken* local_request,
    const DDS_Security_AuthRequestMessageToken* remote_request,
    const DDS_Security_IdentityHandle local, const DDS_Security_IdentityToken* token,
    const DDS_Security_GUID_t* guid, DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  if (guid && guard.is_revoked(*guid)) {
    const auto& id = guid->prefix;
    DDS_Security_Exception_set(
        problem, "Authentication", DDS_SECURITY_ERR_UNDEFINED_CODE, DDS_SECURITY_VALIDATION_FAILED,
        "the member %02x%02x%02x%02x%02x%02x is revoked", id[0], id[1], id[2], id[3], id[4], id[5]);
    return DDS_SECURITY_VALIDATION_FAILED;
  }
  const auto result = guard.original.validate_remote_identity(
      instance, handle, local_request, remote_request, local, token, guid, problem);
  if (guid && handle && result != DDS_SECURITY_VALIDATION_FAILED) guard.note(*guid, *handle);
  return result;
}

DDS_Security_boolean return_identity(dds_security_authentication* instance,
                                     const DDS_Security_IdentityHandle handle,
                                     DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  guard.forget(handle);
  return guard.original.return_identity_handle(instance, handle, problem);
}

DDS_Security_boolean listen(dds_security_authentication* instance,
                            const dds_security_authentication_listener* listener,
                            DDS_Security_SecurityException* problem) {
  auto& guard = guard_of(instance);
  guard.set_listener(listener);
  return guard.original.set_listener(instance, listener, problem);
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
  cyclone->validate_remote_identity = validate_remote;
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
  ended.guard.reset();  // its thread ends before what it calls
  const auto finalise =
      reinterpret_cast<Finalise>(function_in(ended.library, "finalize_authentication"));
  const int result = finalise ? finalise(context) : DDS_RETCODE_ERROR;
  static_cast<void>(ddsrt_dlclose(ended.library));
  return result;
}

}  // extern "C"
