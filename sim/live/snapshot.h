// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/device/frame.h"
#include "core/result.h"

namespace galilean::sim {

/// Writes a picture as PNG, or in another format that the file's extension names. Returns the path.
[[nodiscard]] Result<std::string> write_snapshot(const Frame& frame, const std::string& path);

}  // namespace galilean::sim
