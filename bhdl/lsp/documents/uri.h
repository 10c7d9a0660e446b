// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::bhdl::lsp {

/// Returns the path that a `file:` URI names, percent-decoded and without `.` and `..`. Returns the
/// text of any other URI itself, so that each document has a path.
[[nodiscard]] std::string path_of(std::string_view uri);

/// Returns `file://` and the path, percent-encoded.
[[nodiscard]] std::string uri_of(std::string_view path);

}  // namespace galilean::bhdl::lsp
