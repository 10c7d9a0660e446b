// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "core/wire/types/type_description.h"

struct dds_topic_descriptor;

namespace galilean::wire {

/// A type that this program was built with.
struct OwnType {
  std::string hash;  ///< as EndpointInfo::type_hash
  Type description;
};

/// Returns how this release defines a message, by its name on DDS, or nullptr if it defines none of
/// that name.
[[nodiscard]] const OwnType* find_own_type(std::string_view dds_type);

/// Returns what idlc tells of a type. Errors: idlc was told to leave type information out, or the
/// type holds what cannot be decoded.
[[nodiscard]] Result<OwnType> describe_descriptor(const dds_topic_descriptor& descriptor);

}  // namespace galilean::wire
