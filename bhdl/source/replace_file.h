// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "core/result.h"

namespace galilean::bhdl {

/// Gives a file another text at once: whoever reads it, and whatever happens meanwhile, finds the
/// old text or the new one. Keeps its mode; what a link points to is replaced, not the link.
[[nodiscard]] std::optional<Error> replace_file(const std::filesystem::path& path,
                                                std::string_view text);

}  // namespace galilean::bhdl
