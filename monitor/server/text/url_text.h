// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::monitor {

/// Returns `text` with its percent escapes decoded: "a%20b" gives "a b". A '%' without two
/// hexadecimal digits stays as it is.
[[nodiscard]] std::string percent_decoded(std::string_view text);
/// Returns the decoded value of `name` in the query of `target`: ("/lsp?robot=io&token=x", "robot")
/// gives "io". Returns an empty string if the query does not have that name.
[[nodiscard]] std::string query_value(std::string_view target, std::string_view name);

}  // namespace galilean::monitor
