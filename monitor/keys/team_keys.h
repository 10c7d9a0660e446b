// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/keys/member_role.h"

namespace galilean::monitor {

/// One certificate that a team has issued.
struct TeamMember {
  std::string name;
  MemberRole role = MemberRole::kViewer;
  std::string serial;          ///< 32 hexadecimal digits
  std::int64_t expires_s = 0;  ///< since 1970 (UTC)
  bool revoked = false;

  [[nodiscard]] bool counts(std::int64_t now_s) const noexcept {
    return !revoked && expires_s > now_s;
  }
};

/// The keys of a secured team in a folder: two authorities, what they have issued, and in the
/// folder members/NAME what each member needs. Files have the mode 0600, folders 0700. Editing is
/// safe beside other processes that do so.
class TeamKeys {
 public:
  explicit TeamKeys(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Makes both authorities. Errors: the folder has keys already, or cannot be written.
  [[nodiscard]] Result<void> init() const;
  /// Makes a member, whose keys and grant count until `expires_s` [s since 1970]. Returns its
  /// folder. Errors: the name is not usable or is in use, or the keys cannot be read or written.
  [[nodiscard]] Result<std::filesystem::path> add(const std::string& name, MemberRole role,
                                                  std::int64_t expires_s) const;
  /// Gives a member a new key, certificate and grant of its role. The old ones count until they
  /// expire, so that its running programs stay in the team. Returns its folder. Errors: there is no
  /// such member, or the keys cannot be read or written.
  [[nodiscard]] Result<std::filesystem::path> renew(const std::string& name,
                                                    std::int64_t expires_s) const;
  /// Makes all certificates of a member invalid, and tells so in every member's folder here.
  /// Errors: there is no such member, or the keys cannot be read or written.
  [[nodiscard]] Result<void> revoke(const std::string& name) const;
  /// Returns all certificates, in the order in which they were issued. Errors: the list cannot be
  /// read, or is damaged.
  [[nodiscard]] Result<std::vector<TeamMember>> list() const;

  [[nodiscard]] std::filesystem::path member_folder(const std::string& name) const;

 private:
  [[nodiscard]] Result<std::filesystem::path> issue(const std::string& name, MemberRole role,
                                                    std::int64_t expires_s,
                                                    std::vector<TeamMember> members) const;
  [[nodiscard]] Result<void> write_list(const std::vector<TeamMember>& members) const;
  [[nodiscard]] Result<void> tell_revoked(const std::vector<TeamMember>& members) const;

  std::filesystem::path folder_;
};

}  // namespace galilean::monitor
