#include "bhdl/catalog_file.h"

#include <fstream>
#include <sstream>

namespace galilean::bhdl {

std::filesystem::path default_catalog_path() {
  std::error_code failed;
  const auto executable = std::filesystem::read_symlink("/proc/self/exe", failed);
  const auto binaries = failed ? std::filesystem::current_path(failed) : executable.parent_path();
  return binaries.parent_path() / "share" / "galilean" / "catalog.json";
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
