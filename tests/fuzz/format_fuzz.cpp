// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "bhdl/diff/diff.h"
#include "bhdl/format/formatter.h"
#include "tests/bhdl/small_catalog.h"
#include "tests/fuzz/input.h"

// A text that the formatter lays out must keep its meaning, and must not change when it is laid out
// again.

using namespace galilean::bhdl;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto catalog = small_catalog();
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto once = format_text("0", text);
  must(once.text.has_value() == !any_error(once.diagnostics), "a layout or an error");
  must(std::ranges::none_of(once.diagnostics,
                            [](const auto& each) { return each.code == "format/meaning"; }),
       "a layout means what the text meant");
  if (!once.text) return 0;
  must(format_text("0", *once.text).text == once.text, "formatting twice changes nothing");
  const auto before = check({{"0", text}}, catalog);
  const auto after = check({{"0", *once.text}}, catalog);
  must(before.program.has_value() == after.program.has_value(), "a program stays a program");
  if (before.program)
    must(differences(*before.program, *after.program, catalog).empty(), "it does the same");
  return 0;
}
