// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bhdl/source/source_file.h"

namespace galilean::bhdl {

/// Returns the SHA-256 (FIPS 180-4) of `bytes` as 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view bytes);

/// Returns a program's hash: SHA-256 over the path and the text of every file in order. Each string
/// is preceded by its length (8 bytes, little-endian), so that different lists of files cannot give
/// the same bytes.
[[nodiscard]] std::string program_hash(const std::vector<SourceFile>& files);

}  // namespace galilean::bhdl
