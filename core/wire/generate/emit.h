// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/wire/generate/idl.h"

namespace galilean::idl {

[[nodiscard]] std::string emit_structs(const std::vector<File>& files);
[[nodiscard]] std::string emit_lending_header(const std::vector<File>& files);
[[nodiscard]] std::string emit_lending(const std::vector<File>& files);
[[nodiscard]] std::string emit_schemas(const std::vector<File>& files);

}  // namespace galilean::idl
