// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/keys/team_keys.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/file_lock.h"
#include "core/private_file.h"
#include "core/secure_folder.h"
#include "core/spelling.h"
#include "core/visible_text.h"
#include "monitor/keys/authority.h"
#include "monitor/keys/member_list.h"
#include "monitor/keys/security_documents.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kGrantBeginsEarlier_s = 24 * 3600;  // clocks differ
/// A grant names one certificate alone, whose end counts. Cyclone would delete the participant of a
/// program that still runs when its own grant ends.
constexpr std::int64_t kGrantOutlives_s = std::int64_t{20 * 365} * 24 * 3600;
constexpr std::size_t kLongestMemberName = 64;
/// What stands where a robot's name would, in topics that are no robot's.
constexpr std::array<std::string_view, 9> kNoRobots{"team",        "referee", "simulation",
                                                    "recorder",    "tf",      "tf_static",
                                                    "diagnostics", "rosout",  "clock"};

fs::path list_file(const fs::path& folder) {
  return folder / "members.json";
}

Result<Authority> identity_authority(const fs::path& folder) {
  return Authority::read(MemberFiles(folder).identity_ca, folder / "identity_ca.key");
}

Result<Authority> permissions_authority(const fs::path& folder) {
  return Authority::read(MemberFiles(folder).permissions_ca, folder / "permissions_ca.key");
}

/// The name stands in topics' names, in a folder's name and in documents: nothing in it may have a
/// meaning there.
Result<void> check_member(const std::string& name, MemberRole role) {
  constexpr const char* kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  if (name.empty() || name.size() > kLongestMemberName ||
      name.find_first_not_of(kAllowed) != name.npos)
    return Error{"'" + visible(name) +
                 "' is not a valid name: it has 1 to 64 letters, digits, or characters of _-"};
  if (role == MemberRole::kRobot && std::ranges::find(kNoRobots, name) != kNoRobots.end())
    return Error{"'" + name + "' is the name of topics that are no robot's; choose another"};
  return {};
}

Error no_member(const std::string& name, const std::vector<TeamMember>& members) {
  const std::string meant = nearest(name, names_of(members));
  return Error{"there is no member '" + visible(name) + "'" +
               (meant.empty() ? "; 'galilean team keys list' lists them"
                              : "; did you mean '" + meant + "'?")};
}

/// Returns the newest certificate of that name that is not revoked; the end if there is none.
std::vector<TeamMember>::const_iterator newest_of(const std::string& name,
                                                  const std::vector<TeamMember>& members) {
  auto newest = members.end();
  for (auto each = members.begin(); each != members.end(); ++each)
    if (each->name == name && !each->revoked) newest = each;
  return newest;
}

Result<void> copy_private(const fs::path& from, const fs::path& to) {
  const auto text = read_member_file(from);
  if (!text) return text.error();
  return replace_private_file(to, text.value());
}

Result<FileLock> lock_for_edit(const fs::path& team_folder) {
  std::error_code unknown;
  if (!fs::is_directory(team_folder, unknown))
    return Error{team_folder.string() +
                 " is no folder of a team; make one with 'galilean team keys init', or name it "
                 "with --team"};
  return FileLock::wait_for(team_folder / "members.lock");
}

}  // namespace

fs::path TeamKeys::member_folder(const std::string& name) const {
  return folder_ / kMembersFolder / name;
}

Result<void> TeamKeys::init() const {
  if (auto made = make_private_folder(folder_ / kMembersFolder); !made) return made;
  const auto lock = lock_for_edit(folder_);
  if (!lock) return lock.error();
  const MemberFiles files(folder_);
  std::error_code unknown;
  for (const auto& file : {files.identity_ca, files.permissions_ca, list_file(folder_)})
    if (fs::exists(file, unknown))
      return Error{folder_.string() +
                   " has a team's keys already; choose another folder by --team"};
  const auto identity = Authority::make("galilean identity CA");
  if (!identity) return identity.error();
  const auto permissions = Authority::make("galilean permissions CA");
  if (!permissions) return permissions.error();
  const auto governance = permissions.value().sign(governance_xml());
  if (!governance) return governance.error();
  if (auto done = identity.value().write(files.identity_ca, folder_ / "identity_ca.key"); !done)
    return done;
  if (auto done = permissions.value().write(files.permissions_ca, folder_ / "permissions_ca.key");
      !done)
    return done;
  if (auto done = replace_private_file(files.governance, governance.value()); !done) return done;
  if (auto done = tell_revoked({}); !done) return done;
  return write_list({});
}

Result<fs::path> TeamKeys::add(const std::string& name, MemberRole role,
                               std::int64_t expires_s) const {
  if (const auto valid = check_member(name, role); !valid) return valid.error();
  const auto lock = lock_for_edit(folder_);
  if (!lock) return lock.error();
  auto members = list();
  if (!members) return members.error();
  if (newest_of(name, members.value()) != members.value().end())
    return Error{name + " is a member already; renew it, or revoke it first"};
  return issue(name, role, expires_s, std::move(members).value());
}

Result<fs::path> TeamKeys::renew(const std::string& name, std::int64_t expires_s) const {
  const auto lock = lock_for_edit(folder_);
  if (!lock) return lock.error();
  auto members = list();
  if (!members) return members.error();
  const auto newest = newest_of(name, members.value());
  if (newest == members.value().end()) return no_member(name, members.value());
  const auto role = newest->role;
  return issue(name, role, expires_s, std::move(members).value());
}

Result<fs::path> TeamKeys::issue(const std::string& name, MemberRole role, std::int64_t expires_s,
                                 std::vector<TeamMember> members) const {
  const auto identities = identity_authority(folder_);
  if (!identities) return identities.error();
  const auto permissions = permissions_authority(folder_);
  if (!permissions) return permissions.error();
  const auto identity = identities.value().issue(name, expires_s);
  if (!identity) return identity.error();
  const auto begins_s = static_cast<std::int64_t>(std::time(nullptr)) - kGrantBeginsEarlier_s;
  const auto grant =
      permissions.value().sign(permissions_xml({.name = name,
                                                .subject = identity.value().subject,
                                                .rights = rights_of(role, name),
                                                .from_s = begins_s,
                                                .until_s = expires_s + kGrantOutlives_s}));
  if (!grant) return grant.error();
  // The list first: a certificate that is not in it could not be revoked.
  members.push_back({.name = name,
                     .role = role,
                     .serial = identity.value().serial,
                     .expires_s = expires_s,
                     .revoked = false});
  if (const auto written = write_list(members); !written) return written.error();
  const auto folder = member_folder(name);
  if (const auto made = make_private_folder(folder); !made) return made.error();
  const MemberFiles team(folder_), own(folder);
  for (const auto& [from, to] :
       {std::pair(team.identity_ca, own.identity_ca),
        std::pair(team.permissions_ca, own.permissions_ca),
        std::pair(team.governance, own.governance), std::pair(team.revoked, own.revoked)})
    if (const auto copied = copy_private(from, to); !copied) return copied.error();
  for (const auto& [file, text] : {std::pair(own.key, identity.value().key),
                                   std::pair(own.certificate, identity.value().certificate),
                                   std::pair(own.grant, grant.value())})
    if (const auto written = replace_private_file(file, text); !written) return written.error();
  return folder;
}

Result<void> TeamKeys::revoke(const std::string& name) const {
  const auto lock = lock_for_edit(folder_);
  if (!lock) return lock.error();
  auto read = list();
  if (!read) return read.error();
  auto members = std::move(read).value();
  if (newest_of(name, members) == members.end()) return no_member(name, members);
  for (auto& member : members)
    if (member.name == name) member.revoked = true;
  if (auto written = write_list(members); !written) return written;
  return tell_revoked(members);
}

Result<std::vector<TeamMember>> TeamKeys::list() const {
  return read_member_list(list_file(folder_));
}

Result<void> TeamKeys::write_list(const std::vector<TeamMember>& members) const {
  return replace_private_file(list_file(folder_), member_list_text(members));
}

Result<void> TeamKeys::tell_revoked(const std::vector<TeamMember>& members) const {
  const auto identities = identity_authority(folder_);
  if (!identities) return identities.error();
  std::vector<std::string> serials;
  for (const auto& member : members)
    if (member.revoked) serials.push_back(member.serial);
  const auto text = identities.value().revoked_list(serials);
  if (!text) return text.error();
  if (auto written = replace_private_file(MemberFiles(folder_).revoked, text.value()); !written)
    return written;
  std::error_code unknown;
  for (const auto& member : members) {
    const auto folder = member_folder(member.name);
    if (!fs::is_directory(folder, unknown)) continue;
    if (auto written = replace_private_file(MemberFiles(folder).revoked, text.value()); !written)
      return written;
  }
  return {};
}

}  // namespace galilean::monitor
