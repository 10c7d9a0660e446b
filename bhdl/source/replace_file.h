// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "core/result.h"

namespace galilean::bhdl {

/// Replaces a file's text in one step. A reader finds the old text or the new one, whatever happens
/// meanwhile. The file keeps its mode. If it is a link, the file behind the link is replaced.
/// Returns the error, or nothing.
[[nodiscard]] std::optional<Error> replace_file(const std::filesystem::path& path,
                                                std::string_view text);

}  // namespace galilean::bhdl
