// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "bhdl/program/program.h"

namespace galilean::bhdl {

/// Ends the run, so that the fuzzer keeps the input.
inline void must(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", promise);
  std::abort();
}

/// Returns the input, cut at its NUL bytes into files that are called "0", "1", "2" …. The first is
/// a main file that may include the others.
[[nodiscard]] inline std::vector<SourceFile> files_of(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  std::vector<SourceFile> files;
  for (;;) {
    const auto end = rest.find('\0');
    files.push_back({std::to_string(files.size()), std::string(rest.substr(0, end))});
    if (end == std::string_view::npos) return files;
    rest.remove_prefix(end + 1);
  }
}

}  // namespace galilean::bhdl
