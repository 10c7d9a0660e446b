// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/result.h"

namespace galilean::wire {

/// Returns the folder with the keys of the program that joins as `name`, or nothing if it joins
/// without security. GALILEAN_SECURE names a member's folder, or a team's, in which each program
/// takes the member of its own name. Errors: the folder lacks a file, or the member is not there.
[[nodiscard]] Result<std::optional<std::filesystem::path>> chosen_keys(const std::string& name);

/// Tells Cyclone in `qos` to authenticate, authorise and encrypt with the keys in `folder`.
/// Errors: Galilean's module that asks for revoked members is not installed.
[[nodiscard]] Result<void> add_security(dds_qos_t& qos, const std::filesystem::path& folder);

/// Returns `result`, or 0 if the member's grant does not permit what was asked. That is told once a
/// program for each `what` ("write" or "read"), because a topic without an entity is silent.
/// Errors: throws std::runtime_error if Cyclone refuses for another reason.
std::int32_t permitted(std::int32_t result, const std::string& what, const std::string& topic);

}  // namespace galilean::wire
