// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/program_check.h"

#include <filesystem>
#include <system_error>

#include "bhdl/check.h"
#include "bhdl/program/catalog_file.h"
#include "core/installation.h"
#include "core/visible_text.h"

namespace galilean::front {

Result<void> check_program(const std::string& bhdl) {
  const auto catalog = bhdl::load_catalog(bhdl::default_catalog_path());
  if (!catalog) return Error{catalog.error().message};
  const auto path = find_file(bhdl, "programs", ".bhdl");
  if (std::error_code unknown; !std::filesystem::exists(path, unknown))
    return Error{"no program '" + visible(bhdl) +
                 "': expected a .bhdl file, or the name of a program that ships, such as "
                 "office_cleanup"};
  const auto checked =
      bhdl::check_file(path, bhdl::Vocabulary(catalog.value()), bhdl::Depth::kErrors);
  if (checked.program) return {};
  std::string why = "no robot can run " + visible(bhdl) + ":";
  for (const auto& error : checked.diagnostics) why += "\n" + bhdl::format(error);
  return Error{why};
}

}  // namespace galilean::front
