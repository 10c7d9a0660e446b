// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

namespace galilean {

/// The variable of the environment that names the folder with a program's keys for DDS Security.
/// The option --secure sets it. A program joins without security if it is not set, or empty.
inline constexpr const char* kSecureVariable = "GALILEAN_SECURE";

/// The highest DDS domain that can be secured. DDS has two more, but Cyclone's access control
/// refuses documents that name them.
inline constexpr std::uint32_t kLastSecuredDomain = 230;

/// The folder in a team's folder that has a folder for each member.
inline constexpr const char* kMembersFolder = "members";

/// The files that one member of a secured team needs, as `galilean team keys` makes them. A grant
/// says what a member may write and read. Both CAs are apart, because members could sign grants for
/// themselves if one CA signed certificates and grants (CVE-2023-24011).
struct MemberFiles {
  explicit MemberFiles(const std::filesystem::path& folder)
      : identity_ca(folder / "identity_ca.pem"),
        permissions_ca(folder / "permissions_ca.pem"),
        certificate(folder / "identity.pem"),
        key(folder / "identity.key"),
        governance(folder / "governance.p7s"),
        grant(folder / "permissions.p7s"),
        revoked(folder / "revoked.crl") {}

  std::filesystem::path identity_ca;     ///< the certificate that vouches for members
  std::filesystem::path permissions_ca;  ///< the certificate that vouches for grants
  std::filesystem::path certificate;     ///< who the member is
  std::filesystem::path key;             ///< its private key
  std::filesystem::path governance;      ///< how the team protects its messages
  std::filesystem::path grant;           ///< what the member may do
  std::filesystem::path revoked;         ///< the certificates that count no more
};

}  // namespace galilean
