// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/language/parser.h"
#include "tests/fuzz/input.h"

// Every text of expectations must get an answer, with places inside the text, and what was read
// keeps its words.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using galilean::bhdl::must;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto parsed = galilean::expect::parse("a.expect", text);
  must(parsed.diagnostics.size() <= galilean::bhdl::Diagnostics::kMost + 1,
       "no more than 100 diagnostics");
  must(!parsed.ok() || !parsed.expectations.empty(), "expectations or an error");
  for (const auto& each : parsed.diagnostics) {
    must(each.line >= 1 && each.column >= 1, "every diagnostic has a place");
    must(!each.code.empty() && !each.message.empty(), "every diagnostic says something");
  }
  for (const auto& expectation : parsed.expectations) {
    must(!expectation.claims.empty(), "every expectation claims something");
    for (const auto& claim : expectation.claims) must(!claim.text.empty(), "a claim has words");
  }
  return 0;
}
