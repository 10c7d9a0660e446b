// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

struct DDS_XTypes_TypeIdentifier;

namespace galilean::wire {

/// Returns the hash by which XTypes names the whole definition of a type, in hexadecimal. It is
/// empty if `id` is no such hash.
[[nodiscard]] std::string type_hash(const DDS_XTypes_TypeIdentifier& id);
/// Returns the identifier of that hash. Requires: `hash` comes from type_hash and is not empty.
[[nodiscard]] DDS_XTypes_TypeIdentifier type_identifier(std::string_view hash);

}  // namespace galilean::wire
