// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::monitor {

/// "a%20b" -> "a b"; what is no escape stays as it is.
[[nodiscard]] std::string percent_decoded(std::string_view text);
/// "io" of ("/lsp?robot=io&token=x", "robot"), decoded; empty where the query does not name it.
[[nodiscard]] std::string query_value(std::string_view target, std::string_view name);

}  // namespace galilean::monitor
