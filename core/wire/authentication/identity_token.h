// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dds/security/dds_security_api_types.h>

#include <cstdint>
#include <string_view>

namespace galilean::wire {

// What programs announce of their certificates in discovery (DDS Security 1.1, 9.3.2.1). Nothing of
// it is proven: it can tell why a program will be refused, and never that it is let in.

/// Returns the value of that property, or an empty text if the token has none.
inline std::string_view property_in(const DDS_Security_IdentityToken& token,
                                    std::string_view name) noexcept {
  const auto& properties = token.properties;
  for (std::uint32_t i = 0; i < properties._length; ++i) {
    const auto& property = properties._buffer[i];
    if (property.name && property.value && name == property.name) return property.value;
  }
  return {};
}

/// Returns the subject of the CA that is said to vouch for the certificate.
inline std::string_view authority_in(const DDS_Security_IdentityToken& token) noexcept {
  return property_in(token, "dds.ca.sn");
}

/// Returns the subject that the certificate is said to have.
inline std::string_view subject_in(const DDS_Security_IdentityToken& token) noexcept {
  return property_in(token, "dds.cert.sn");
}

}  // namespace galilean::wire
