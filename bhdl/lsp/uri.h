// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::bhdl::lsp {

/// The path that a `file:` URI names, without `.` and `..`; of any other URI its own text, so that
/// each document has a path. Percent signs are decoded.
[[nodiscard]] std::string path_of(std::string_view uri);

/// `file://` and the path, percent-encoded.
[[nodiscard]] std::string uri_of(std::string_view path);

}  // namespace galilean::bhdl::lsp
