// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace galilean {

/// Returns what is wrong with the first word that a command line does not know, and what may have
/// been meant. Returns nothing if it knows all. Requires: `app` has parsed the arguments.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app);

}  // namespace galilean
