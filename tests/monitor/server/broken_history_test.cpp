// SPDX-License-Identifier: BSD-3-Clause
// A disk that fails: who asks is told so, and nothing is sent that would not be remembered.
#include "monitor/pushes/history/sql.h"
#include "tests/monitor/scripted_robot.h"
#include "tests/monitor/server/server_fixture.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;

class BrokenHistoryTest : public ServerFixture {
 protected:
  /// What the monitor then finds in its file is what a damaged one has.
  void break_history() const {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((folder / "history.sqlite").c_str(), &database), SQLITE_OK);
    for (const auto* table : {"answer", "progress", "push", "program_file"})
      sql::execute(database, ("DROP TABLE " + std::string(table)).c_str());
    sqlite3_close(database);
  }
};

TEST_F(BrokenHistoryTest, IsToldToWhoAsksForIt) {
  break_history();
  for (const auto* path : {"/api/pushes", "/api/pushes/nothing", "/api/pushed/nothing"}) {
    const auto answer = get(path);
    EXPECT_EQ(answer.status, 503U) << path;
    EXPECT_EQ(answer.type, "application/problem+json");
    EXPECT_THAT(answer.as_json()["detail"].get<std::string>(), HasSubstr("no such table")) << path;
  }
  EXPECT_EQ(get("/healthz").status, 200U);
}

TEST_F(BrokenHistoryTest, NothingIsPushedAndTheRobotsAreFreeForTheNextPush) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  break_history();
  for (int i = 0; i < 2; ++i) {
    const auto refused = post("/api/push", {{"files", files(kProgram)}});
    EXPECT_EQ(refused.status, 503U) << refused.body;
    EXPECT_THAT(refused.as_json()["detail"].get<std::string>(), HasSubstr("nothing was pushed"));
  }
  EXPECT_EQ(io.running_hash(), "first");
  EXPECT_EQ(post("/api/command", {{"kind", "hold"}}).status, 200U) << "the worker works on";
  EXPECT_TRUE(becomes_true([&] { return io.held(); }));
  // Who pushed the program that runs can no longer be looked up.
  EXPECT_EQ(post("/api/push", {{"files", files(kProgram)}, {"replaces", "another"}}).status, 503U);
}

}  // namespace
}  // namespace galilean::monitor
