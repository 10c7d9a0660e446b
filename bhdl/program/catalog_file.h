// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/catalog/catalog.h"
#include "core/result.h"

namespace galilean::bhdl {

/// Returns the path of the shipped catalog, which the build wrote from the robot's component list.
[[nodiscard]] std::filesystem::path default_catalog_path();

/// Reads a catalog's JSON. Errors: the file cannot be read or is no catalog; the error names the
/// file and what is wrong.
[[nodiscard]] Result<Catalog> load_catalog(const std::filesystem::path& path);

}  // namespace galilean::bhdl
