// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>

#include "core/installation.h"
#include "core/regular_file.h"
#include "sim/scenario/scenario.h"

namespace galilean::sim {
namespace {

namespace fs = std::filesystem;
constexpr std::uintmax_t kLargestFile_bytes = 1 << 20;

std::string known_names() {
  std::string names;
  for (const auto& name : shipped_scenarios()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

std::vector<std::string> shipped_scenarios() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(shipped("scenarios"), error))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Result<Scenario> load_scenario(const std::string& name_or_path) {
  std::error_code error;
  const fs::path path = find_file(name_or_path, "scenarios", ".json");
  if (!fs::is_regular_file(path, error))
    return Error{"no scenario '" + name_or_path + "': expected a .json file or one of " +
                 known_names()};
  if (fs::file_size(path, error) > kLargestFile_bytes)
    return Error{path.string() + ": larger than 1 MiB; no scenario is"};
  const auto text = read_regular_file(path.string(), kLargestFile_bytes);
  if (!text) return Error{path.string() + ": cannot be read: " + text.error().message};
  return scenario_from_json(text.value(), path.string());
}

}  // namespace galilean::sim
