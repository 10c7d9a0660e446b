// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "core/result.h"

namespace galilean::monitor {

/// The end of the names of recordings.
inline constexpr std::string_view kRecordingExtension = ".mcap";

/// Returns whether a file of that name is listed as a recording, though its name may be none that
/// check_recording_name() lets through.
[[nodiscard]] bool is_listed_name(std::string_view name);

/// Errors: `name` is no name of a recording, but a path, the name of a hidden file, too long, has
/// characters that cannot be seen, or does not end with kRecordingExtension. The error is a
/// sentence.
[[nodiscard]] Result<void> check_recording_name(std::string_view name);

}  // namespace galilean::monitor
