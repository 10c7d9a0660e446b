// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean {

/// Who runs this process, for what it signs: $USER, else the account's name, else its number.
[[nodiscard]] std::string user_name();

}  // namespace galilean
