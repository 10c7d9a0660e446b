// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/language/expectation_files.h"

#include <algorithm>
#include <iterator>

#include "bhdl/source/source_provider.h"

namespace galilean::expect {
namespace {

Parsed parse_file(const std::string& path) {
  const auto text = bhdl::DiskSources({}).read(path, kMostBytes);
  if (text) return parse(path, text.value());
  const bool large = text.error().code == "file/too-large";
  Parsed parsed;
  parsed.diagnostics.push_back(
      {.file = path,
       .code = text.error().code,
       .message = large ? "the file is too large; expectations have at most " +
                              std::to_string(kMostBytes) + " bytes"
                        : text.error().message});
  return parsed;
}

}  // namespace

Parsed parse_files(const std::vector<std::string>& paths) {
  Parsed all;
  for (const auto& path : paths) {
    auto parsed = parse_file(path);
    std::ranges::move(parsed.expectations, std::back_inserter(all.expectations));
    std::ranges::move(parsed.diagnostics, std::back_inserter(all.diagnostics));
  }
  return all;
}

}  // namespace galilean::expect
