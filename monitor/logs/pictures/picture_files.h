// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"
#include "monitor/logs/pictures/drawing.h"

namespace galilean::logs {

/// Where a drawing goes.
struct PictureFiles {
  std::string svg, png;  ///< an empty path: no such picture
  bool replace = false;  ///< overwrite what is there
  [[nodiscard]] bool any() const noexcept { return !svg.empty() || !png.empty(); }
};

/// Writes the pictures that are asked for. Errors: one cannot be made or written, or is there
/// already.
[[nodiscard]] Result<void> write_pictures(const PictureFiles& files, const Drawing& drawing);

}  // namespace galilean::logs
