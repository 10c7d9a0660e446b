// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/program/catalog_file.h"

#include "core/installation.h"
#include "core/regular_file.h"

namespace galilean::bhdl {
namespace {

/// Far more than a catalog has.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;

}  // namespace

std::filesystem::path default_catalog_path() {
  return shipped("catalog.json");
}

Result<Catalog> load_catalog(const std::filesystem::path& path) {
  const auto text = read_regular_file(path.string(), kMostBytes);
  if (!text)
    return Error{"cannot read the catalog " + path.string() + ", because " + text.error().message +
                 ": build the project, or name a catalog with --catalog FILE"};
  auto catalog = catalog_from_json(text.value());
  if (!catalog) return Error{path.string() + ": " + catalog.error().message};
  return catalog;
}

}  // namespace galilean::bhdl
