// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/logs/pictures/drawing.h"

namespace galilean::logs {

inline constexpr auto kPngModuleFile = "libgalilean_png.so";
inline constexpr auto kDrawPng = "galilean_draw_png";

/// The function that the module exports. It fills `png` with the bytes of the picture. Returns
/// false if the picture cannot be made, as one that is too large.
using DrawPng = bool (*)(const Drawing& drawing, std::string& png);

}  // namespace galilean::logs
