// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/run_logs.h"

#include <algorithm>
#include <vector>

namespace galilean::front {

namespace fs = std::filesystem;

fs::path new_run(const fs::path& logs, const std::string& name) {
  std::error_code unknown;
  fs::path run = logs / name;
  for (int number = 2; fs::exists(run, unknown); ++number)
    run = logs / (name + "-" + std::to_string(number));
  return run;
}

void forget_old_runs(const fs::path& logs, std::size_t kept) {
  std::error_code ignored;
  std::vector<fs::directory_entry> runs;
  for (const auto& entry : fs::directory_iterator(logs, ignored))
    if (entry.path().filename().string().starts_with("run-")) runs.push_back(entry);
  std::ranges::sort(runs, [&](const auto& a, const auto& b) {
    return a.last_write_time(ignored) > b.last_write_time(ignored);
  });
  for (std::size_t i = kept; i < runs.size(); ++i) fs::remove_all(runs[i].path(), ignored);
}

}  // namespace galilean::front
