// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/catalog/catalog.h"
#include "core/result.h"

namespace galilean::bhdl {

/// The catalog that the build wrote from the robot's component list, as it ships.
[[nodiscard]] std::filesystem::path default_catalog_path();

/// Reads a catalog's JSON. Errors name the file and what is wrong in it.
[[nodiscard]] Result<Catalog> load_catalog(const std::filesystem::path& path);

}  // namespace galilean::bhdl
