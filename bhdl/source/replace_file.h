// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "core/result.h"

namespace galilean::bhdl {

/// Replaces a file's text in one step. A reader finds the old text or the new one, whatever happens
/// meanwhile. The file keeps its mode. If it is a link, the file behind the link is replaced.
/// Errors: the file is missing or cannot be written; it is then as it was.
Result<void> replace_file(const std::filesystem::path& path, std::string_view text);

}  // namespace galilean::bhdl
