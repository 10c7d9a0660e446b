// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"
#include "monitor/logs/pictures/drawing.h"

namespace galilean::logs {

/// Returns the drawing as the bytes of a PNG picture. OpenCV's libraries take a tenth of a second
/// to load. They are therefore in a module that the first call loads. Errors: the module is not
/// beside the executable or cannot be loaded, or the picture is too large.
[[nodiscard]] Result<std::string> png_of(const Drawing& drawing);

}  // namespace galilean::logs
