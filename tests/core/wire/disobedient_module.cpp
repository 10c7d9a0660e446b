// SPDX-License-Identifier: BSD-3-Clause
// The plugins of a program that was changed so that it obeys no role: it asks for any topic, with
// keys and grant of its own. A program loads this in place of Galilean's module if it stands beside
// the executable under the module's name.
#include <dds/ddsrt/dynlib.h>
#include <dds/ddsrt/retcode.h>
#include <dds/security/dds_security_api_access_control.h>

namespace {

constexpr const char* kAuthentication = "dds_security_auth";
constexpr const char* kAccessControl = "dds_security_ac";

using Initialise = int (*)(const char*, void**, ddsi_domaingv*);
using Finalise = int (*)(void*);

/// Returns a function of one of Cyclone's plugins, which stays loaded, or null.
template <class Function>
Function function_of(const char* plugin, const char* name) {
  ddsrt_dynlib_t library = nullptr;
  void* function = nullptr;
  if (ddsrt_dlopen(plugin, true, &library) != DDS_RETCODE_OK ||
      ddsrt_dlsym(library, name, &function) != DDS_RETCODE_OK)
    return nullptr;
  return reinterpret_cast<Function>(function);
}

DDS_Security_boolean permit_endpoint(
    dds_security_access_control*, const DDS_Security_PermissionsHandle, const DDS_Security_DomainId,
    const DDS_Security_char*, const DDS_Security_Qos*, const DDS_Security_PartitionQosPolicy*,
    const DDS_Security_DataTags*, DDS_Security_SecurityException*) {
  return true;
}

DDS_Security_boolean permit_topic(dds_security_access_control*,
                                  const DDS_Security_PermissionsHandle, const DDS_Security_DomainId,
                                  const DDS_Security_char*, const DDS_Security_Qos*,
                                  DDS_Security_SecurityException*) {
  return true;
}

int initialise(const char* plugin, const char* name, const char* argument, void** context,
               ddsi_domaingv* domain) {
  const auto function = function_of<Initialise>(plugin, name);
  return function ? function(argument, context, domain) : DDS_RETCODE_ERROR;
}

int finalise(const char* plugin, const char* name, void* context) {
  const auto function = function_of<Finalise>(plugin, name);
  return function ? function(context) : DDS_RETCODE_ERROR;
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) int galilean_init_authentication(const char* argument,
                                                                        void** context,
                                                                        ddsi_domaingv* domain) {
  return initialise(kAuthentication, "init_authentication", argument, context, domain);
}

__attribute__((visibility("default"))) int galilean_finalize_authentication(void* context) {
  return finalise(kAuthentication, "finalize_authentication", context);
}

__attribute__((visibility("default"))) int galilean_init_access_control(const char* argument,
                                                                        void** context,
                                                                        ddsi_domaingv* domain) {
  const int made = initialise(kAccessControl, "init_access_control", argument, context, domain);
  if (made != DDS_RETCODE_OK) return made;
  auto* access = static_cast<dds_security_access_control*>(*context);
  access->check_create_topic = permit_topic;
  access->check_create_datawriter = permit_endpoint;
  access->check_create_datareader = permit_endpoint;
  return DDS_RETCODE_OK;
}

__attribute__((visibility("default"))) int galilean_finalize_access_control(void* context) {
  return finalise(kAccessControl, "finalize_access_control", context);
}

}  // extern "C"
