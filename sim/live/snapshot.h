// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/device/frame.h"
#include "core/result.h"

namespace galilean::sim {

/// Writes a picture as PNG (or what else the file's extension says). Gives back the path.
[[nodiscard]] Result<std::string> write_snapshot(const Frame& frame, const std::string& path);

}  // namespace galilean::sim
