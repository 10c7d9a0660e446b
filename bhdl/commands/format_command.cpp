// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/commands/format_command.h"

#include <filesystem>
#include <iostream>

#include "bhdl/format/formatter.h"
#include "bhdl/source/replace_file.h"
#include "bhdl/syntax/loader.h"
#include "core/visible_text.h"

namespace galilean::bhdl {
namespace {

constexpr std::string_view kStandardInput = "-";

Result<std::string, ReadFailure> read_standard_input() {
  std::string text(kMostFileBytes + 1, '\0');
  std::cin.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::cin.gcount()));
  if (text.size() <= kMostFileBytes) return text;
  return ReadFailure{"file/too-large", "standard input has more than " +
                                           std::to_string(kMostFileBytes) +
                                           " bytes, the most that a BHDL file has"};
}

Result<std::string, ReadFailure> read_text(const std::string& file) {
  if (file == kStandardInput) return read_standard_input();
  const std::filesystem::path path(file);
  return DiskSources(path.parent_path()).read(path.filename().string(), kMostFileBytes);
}

bool put(const std::string& file, const std::string& old_text, const std::string& new_text,
         bool check_only) {
  const bool changes = old_text != new_text;
  if (check_only) {
    if (changes) std::cout << file << '\n';
    return !changes;
  }
  if (file == kStandardInput) {
    std::cout << new_text << std::flush;
    return std::cout.good();
  }
  if (!changes) return true;
  if (const auto replaced = replace_file(file, new_text); !replaced) {
    std::cerr << "galilean-bhdl: " << replaced.error().message << '\n';
    return false;
  }
  std::cout << file << '\n';
  return true;
}

bool format_file(const std::string& file, bool check_only) {
  const auto text = read_text(file);
  const std::string shown = file == kStandardInput ? "<stdin>" : file;
  if (!text) {
    std::cerr << visible(shown) << ":1:1: error: " << text.error().message << '\n';
    return false;
  }
  const Formatted formatted = format_text(shown, text.value());
  for (const auto& diagnostic : formatted.diagnostics) std::cerr << format(diagnostic) << '\n';
  if (formatted.text) return put(file, text.value(), *formatted.text, check_only);
  std::cerr << "galilean-bhdl: " << visible(shown) << " is left as it is\n";
  return false;
}

}  // namespace

int run_format(const std::vector<std::string>& files, bool check_only) {
  bool all_right = true;
  for (const auto& file : files) all_right = format_file(file, check_only) && all_right;
  return all_right ? 0 : 1;
}

}  // namespace galilean::bhdl
