// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/program_check.h"

#include "bhdl/check.h"
#include "bhdl/program/catalog_file.h"
#include "core/installation.h"

namespace galilean::front {

Result<void> check_program(const std::string& bhdl) {
  const auto catalog = bhdl::load_catalog(bhdl::default_catalog_path());
  if (!catalog) return Error{catalog.error().message};
  const auto checked = bhdl::check_file(find_file(bhdl, "programs", ".bhdl"),
                                        bhdl::Vocabulary(catalog.value()), bhdl::Depth::kErrors);
  if (checked.program) return {};
  std::string why = "no robot can run " + bhdl + ":";
  for (const auto& error : checked.diagnostics) why += "\n" + bhdl::format(error);
  return Error{why};
}

}  // namespace galilean::front
