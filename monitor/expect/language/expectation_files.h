// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/expect/language/parser.h"

namespace galilean::expect {

/// Reads all expectations of these files. That a file cannot be read is a diagnostic, too.
[[nodiscard]] Parsed parse_files(const std::vector<std::string>& paths);

}  // namespace galilean::expect
