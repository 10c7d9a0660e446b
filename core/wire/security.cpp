// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/security.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <set>
#include <utility>

#include "core/installation.h"
#include "core/secure_folder.h"
#include "core/wire/qos.h"

namespace galilean::wire {
namespace {

namespace fs = std::filesystem;

constexpr auto kModule = "libgalilean_authentication.so";
/// Folders of the module relative to the executable: in the build, for the build's tests,
/// installed.
constexpr std::array kModuleFolders{".", "../bin", "../lib/galilean"};

bool is_readable(const fs::path& file) {
  return access(file.c_str(), R_OK) == 0;
}

/// Errors: a file is missing or is another user's. The sentence names it.
Result<void> check_member_files(const fs::path& folder) {
  const MemberFiles files(folder);
  for (const auto& file : {files.identity_ca, files.permissions_ca, files.certificate, files.key,
                           files.governance, files.grant, files.revoked})
    if (!is_readable(file))
      return Error{file.string() +
                   " cannot be read; --secure needs a whole folder of a member, as 'galilean team "
                   "keys add' makes it"};
  return {};
}

Result<fs::path> find_security_module() {
  for (const auto* relative : kModuleFolders)
    if (const auto file = program_folder() / relative / kModule; is_readable(file)) return file;
  return Error{std::string(kModule) +
               " is not beside the executable: build or install it, because without it a revoked "
               "member could join"};
}

}  // namespace

Result<std::optional<fs::path>> chosen_keys(const std::string& name) {
  const char* given = std::getenv(kSecureVariable);
  if (!given || !*given) return std::optional<fs::path>();
  std::error_code unknown;
  fs::path folder = fs::absolute(given, unknown);
  if (fs::is_directory(folder / kMembersFolder, unknown)) {
    const auto member = folder / kMembersFolder / name;
    if (!fs::is_directory(member, unknown))
      return Error{folder.string() + " has no member '" + name +
                   "'; add it with 'galilean team keys add " + name +
                   "', or name another member's folder with --secure"};
    folder = member;
  }
  if (const auto whole = check_member_files(folder); !whole) return whole.error();
  return std::optional<fs::path>(std::move(folder));
}

Result<void> add_security(dds_qos_t& qos, const fs::path& folder) {
  const auto module_file = find_security_module();
  if (!module_file) return module_file.error();
  const MemberFiles files(folder);
  const auto set = [&](const char* property, const std::string& value) {
    dds_qset_prop(&qos, property, value.c_str());
  };
  const auto set_file = [&](const char* property, const fs::path& file) {
    set(property, "file:" + file.string());
  };
  set("dds.sec.auth.library.path", module_file.value().string());
  set("dds.sec.auth.library.init", "galilean_init_authentication");
  set("dds.sec.auth.library.finalize", "galilean_finalize_authentication");
  set("dds.sec.access.library.path", module_file.value().string());
  set("dds.sec.access.library.init", "galilean_init_access_control");
  set("dds.sec.access.library.finalize", "galilean_finalize_access_control");
  set("dds.sec.crypto.library.path", "dds_security_crypto");
  set("dds.sec.crypto.library.init", "init_crypto");
  set("dds.sec.crypto.library.finalize", "finalize_crypto");
  set_file("dds.sec.auth.identity_ca", files.identity_ca);
  set_file("dds.sec.auth.identity_certificate", files.certificate);
  set_file("dds.sec.auth.private_key", files.key);
  set_file("org.eclipse.cyclonedds.sec.auth.crl", files.revoked);
  set_file("dds.sec.access.permissions_ca", files.permissions_ca);
  set_file("dds.sec.access.governance", files.governance);
  set_file("dds.sec.access.permissions", files.grant);
  return {};
}

std::int32_t permitted(std::int32_t result, const std::string& what, const std::string& topic) {
  if (result != DDS_RETCODE_NOT_ALLOWED_BY_SECURITY) return checked(result, what + ' ' + topic);
  static std::mutex mutex;
  static auto* const told = new std::set<std::string>;
  const std::lock_guard lock(mutex);
  if (told->insert(what).second)
    std::cerr << "galilean: the role of these keys does not let this program " << what << ' '
              << topic
              << ", and perhaps others, which are left out; 'galilean team keys add' gives "
              << "keys of another role\n";
  return 0;
}

}  // namespace galilean::wire
