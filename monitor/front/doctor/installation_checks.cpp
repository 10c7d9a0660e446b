// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <set>

#include "core/installation.h"
#include "monitor/front/doctor/checks.h"
#include "monitor/front/siblings.h"
#include "monitor/front/verbs.h"

namespace galilean::front {
namespace fs = std::filesystem;

Check check_programs() {
  std::set<std::string> missing;
  for (const auto& verb : verbs())
    if (!is_program(sibling(verb.program))) missing.emplace(verb.program);
  std::string list;
  for (const auto& program : missing) list += (list.empty() ? "" : ", ") + program;
  const std::string folder = program_folder().string();
  if (missing.empty()) return {"programs", true, "all in " + folder};
  return {"programs", false, "missing in " + folder + ": " + list,
          "build them: ./demo.sh does, or ninja -C build programs"};
}

Check check_page() {
  const fs::path page = shipped("web") / "index.html";
  if (fs::exists(page)) return {"page", true, page.string()};
  return {"page", false, page.string() + " is not there",
          "build it: ./demo.sh does. Robots, top and record work without it"};
}

Check check_devices() {
  std::vector<std::string> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/dev", ignored)) {
    const std::string name = entry.path().filename().string();
    for (const char* kind : {"ttyUSB", "ttyACM", "video"})
      if (name.starts_with(kind)) found.push_back(entry.path().string());
  }
  std::sort(found.begin(), found.end());
  std::string list;
  for (const auto& device : found) list += (list.empty() ? "" : ", ") + device;
  return {"real devices", true,
          list.empty() ? "there is no serial board and no camera; the simulator needs none" : list};
}

}  // namespace galilean::front
