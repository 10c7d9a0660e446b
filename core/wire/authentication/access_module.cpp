// SPDX-License-Identifier: BSD-3-Clause
// Cyclone's access control, which also tells when a member asks for what its role does not permit.
// Cyclone is silent there where topics' names are secret. An honest program does not ask: its own
// access control refuses it before.
#include <dds/ddsrt/dynlib.h>
#include <dds/ddsrt/log.h>
#include <dds/ddsrt/retcode.h>
#include <dds/security/dds_security_api_access_control.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <mutex>

namespace galilean::wire {
namespace {

constexpr const char* kAccessLibrary = "dds_security_ac";

/// One instance of Cyclone's a domain, with its functions before they were replaced.
struct LoadedAccess {
  ddsrt_dynlib_t library = nullptr;
  dds_security_access_control original{};
};
std::mutex access_mutex;
std::map<void*, LoadedAccess> loaded_access;

/// Returns the functions of Cyclone's instance. Requires: it is loaded.
const dds_security_access_control& original_access(const dds_security_access_control* instance) {
  const std::lock_guard lock(access_mutex);
  return loaded_access.at(const_cast<dds_security_access_control*>(instance)).original;
}

/// Who logs this tells each line once. `participant` begins with what RevocationGuard knows members
/// by. The topic's name is the member's own choice.
void tell_forbidden(const DDS_Security_BuiltinTopicKey_t& participant, const char* what,
                    const char* topic) {
  std::array<std::uint8_t, 6> id{};
  std::memcpy(id.data(), &participant, id.size());
  dds_log(DDS_LC_WARNING, __FILE__, __LINE__, "tell_forbidden",
          "the role of the member %02x%02x%02x%02x%02x%02x does not let it %s %.200s\n", id[0],
          id[1], id[2], id[3], id[4], id[5], what, topic ? topic : "");
}

DDS_Security_boolean check_remote_writer(
    dds_security_access_control* instance, const DDS_Security_PermissionsHandle member,
    const DDS_Security_DomainId domain,
    const DDS_Security_PublicationBuiltinTopicDataSecure* writer,
    DDS_Security_SecurityException* problem) {
  const auto allowed =
      original_access(instance).check_remote_datawriter(instance, member, domain, writer, problem);
  if (!allowed && writer) tell_forbidden(writer->participant_key, "write", writer->topic_name);
  return allowed;
}

DDS_Security_boolean check_remote_reader(
    dds_security_access_control* instance, const DDS_Security_PermissionsHandle member,
    const DDS_Security_DomainId domain,
    const DDS_Security_SubscriptionBuiltinTopicDataSecure* reader, DDS_Security_boolean* relay_only,
    DDS_Security_SecurityException* problem) {
  const auto allowed = original_access(instance).check_remote_datareader(
      instance, member, domain, reader, relay_only, problem);
  if (!allowed && reader) tell_forbidden(reader->participant_key, "read", reader->topic_name);
  return allowed;
}

void* access_function(ddsrt_dynlib_t library, const char* name) {
  void* function = nullptr;
  return ddsrt_dlsym(library, name, &function) == DDS_RETCODE_OK ? function : nullptr;
}

using InitialiseAccess = int (*)(const char*, void**, ddsi_domaingv*);
using FinaliseAccess = int (*)(void*);

}  // namespace
}  // namespace galilean::wire

extern "C" {

__attribute__((visibility("default"))) int galilean_init_access_control(const char* argument,
                                                                        void** context,
                                                                        ddsi_domaingv* domain) {
  using namespace galilean::wire;
  LoadedAccess made;
  if (ddsrt_dlopen(kAccessLibrary, true, &made.library) != DDS_RETCODE_OK) return DDS_RETCODE_ERROR;
  const auto initialise =
      reinterpret_cast<InitialiseAccess>(access_function(made.library, "init_access_control"));
  if (!initialise || initialise(argument, context, domain) != DDS_RETCODE_OK) {
    static_cast<void>(ddsrt_dlclose(made.library));
    return DDS_RETCODE_ERROR;
  }
  auto* cyclone = static_cast<dds_security_access_control*>(*context);
  made.original = *cyclone;
  cyclone->check_remote_datawriter = check_remote_writer;
  cyclone->check_remote_datareader = check_remote_reader;
  const std::lock_guard lock(access_mutex);
  loaded_access[*context] = made;
  return DDS_RETCODE_OK;
}

__attribute__((visibility("default"))) int galilean_finalize_access_control(void* context) {
  using namespace galilean::wire;
  LoadedAccess ended;
  {
    const std::lock_guard lock(access_mutex);
    const auto found = loaded_access.find(context);
    if (found == loaded_access.end()) return DDS_RETCODE_ERROR;
    ended = found->second;
    loaded_access.erase(found);
  }
  const auto finalise =
      reinterpret_cast<FinaliseAccess>(access_function(ended.library, "finalize_access_control"));
  const int result = finalise ? finalise(context) : DDS_RETCODE_ERROR;
  static_cast<void>(ddsrt_dlclose(ended.library));
  return result;
}

}  // extern "C"
