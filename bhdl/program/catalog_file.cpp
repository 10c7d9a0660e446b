// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/program/catalog_file.h"

#include <fstream>
#include <sstream>

#include "core/installation.h"

namespace galilean::bhdl {

std::filesystem::path default_catalog_path() {
  return shipped("catalog.json");
}

Result<Catalog> load_catalog(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf()))
    return Error{"cannot read the catalog " + path.string() +
                 ": build the project, or name a catalog with --catalog FILE"};
  auto catalog = catalog_from_json(text.str());
  if (!catalog) return Error{path.string() + ": " + catalog.error().message};
  return catalog;
}

}  // namespace galilean::bhdl
