// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/run_logs.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/temporary_folder.h"

namespace galilean::front {
namespace {

namespace fs = std::filesystem;

TEST(RunLogs, TheNewestStayAndNothingElseIsTouched) {
  const TemporaryFolder folder;
  const fs::path logs = folder / "logs";
  const auto now = fs::file_time_type::clock::now();
  for (int age = 0; age < 5; ++age) {
    const fs::path run = logs / ("run-" + std::to_string(age));
    fs::create_directories(run);
    std::ofstream(run / "io.log") << "up\n";
    fs::last_write_time(run, now - std::chrono::hours(age));
  }
  fs::create_directories(logs / "notes");

  forget_old_runs(logs, 2);
  for (int age = 0; age < 5; ++age)
    EXPECT_EQ(fs::exists(logs / ("run-" + std::to_string(age))), age < 2) << age;
  EXPECT_TRUE(fs::exists(logs / "notes"));
  fs::remove_all(logs);
  forget_old_runs(logs, 2);
}

TEST(RunLogs, ARunNeverGoesIntoTheFolderOfAnother) {
  const TemporaryFolder folder;
  const fs::path logs = folder / "logs";
  EXPECT_EQ(new_run(logs, "run-7"), logs / "run-7");
  for (const char* name : {"run-7", "run-7-2"}) fs::create_directories(logs / name);
  EXPECT_EQ(new_run(logs, "run-7"), logs / "run-7-3");
}

}  // namespace
}  // namespace galilean::front
