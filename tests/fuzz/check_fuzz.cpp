// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bhdl/small_catalog.h"
#include "tests/fuzz/input.h"

// Every text must get an answer, with places inside the text, and the same answer each time.

using namespace galilean::bhdl;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto catalog = small_catalog();
  const auto files = files_of(data, size);
  const auto result = check(files, catalog);
  must(result.program.has_value() == !any_error(result.diagnostics), "a program or an error");
  must(result.diagnostics.size() <= Diagnostics::kMost + 1, "no more than 100 diagnostics");
  for (const auto& each : result.diagnostics) {
    must(each.line >= 1 && each.column >= 1, "every diagnostic has a place");
    must(!each.code.empty() && !each.message.empty(), "every diagnostic says something");
  }
  must(printed(check(files, catalog)) == printed(result), "the same answer twice");
  return 0;
}
