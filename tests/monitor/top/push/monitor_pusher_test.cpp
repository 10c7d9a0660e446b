// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/push/monitor_pusher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <deque>
#include <filesystem>
#include <fstream>

#include "tests/temporary_folder.h"

namespace galilean::monitor::top {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using Answer = Result<MonitorAnswer, Unanswered>;
using Stage = PushReport::Stage;

constexpr const char* kProgram = "states:\n  state:\n    name: \"wait\"\n  end\nend\n";

/// A monitor that answers each request when it is told to.
class ScriptedMonitor {
 public:
  /// Adds the answer to a request for this path. The request waits until there is one.
  void answer(const std::string& path, Answer answer) {
    const std::lock_guard lock(mutex_);
    answers_[path].push_back(std::move(answer));
    changed_.notify_all();
  }
  Answer ask(const std::string& path, const std::optional<json>& body) {
    std::unique_lock lock(mutex_);
    ++asked_[path];
    if (body) bodies_[path] = *body;
    changed_.notify_all();
    if (path == "/api/status") return MonitorAnswer{200, json{{"may_steer", true}}};
    changed_.wait(lock, [&] { return !answers_[path].empty(); });
    Answer answer = answers_[path].front();
    answers_[path].pop_front();
    return answer;
  }
  [[nodiscard]] int asked(const std::string& path) {
    const std::lock_guard lock(mutex_);
    return asked_[path];
  }
  [[nodiscard]] json last_body(const std::string& path) {
    const std::lock_guard lock(mutex_);
    return bodies_[path];
  }
  /// Waits until the path has been asked for so many times.
  void wait_for(const std::string& path, int times = 1) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return asked_[path] >= times; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, std::deque<Answer>> answers_;
  std::map<std::string, int> asked_;
  std::map<std::string, json> bodies_;
};

class MonitorPusherTest : public testing::Test {
 protected:
  std::string file(const std::string& name) {
    std::ofstream(folder.path() / name) << kProgram;
    return folder.path() / name;
  }
  /// Waits until the report is at this stage, and returns it.
  PushReport wait_for(Stage stage) {
    wait_until([&] { return pusher->report().stage == stage; });
    return pusher->report();
  }
  static void wait_until(const std::function<bool()>& condition) {
    const auto begin = std::chrono::steady_clock::now();
    while (!condition() && std::chrono::steady_clock::now() - begin < std::chrono::seconds(10))
      std::this_thread::yield();
  }
  void check(const std::string& name) {
    pusher->check({.file = file(name)});
    monitor->answer("/api/check", MonitorAnswer{200, json{{"ok", true}, {"hash", "3f2a91c0"}}});
    ASSERT_EQ(wait_for(Stage::kReady).stage, Stage::kReady);
  }

  TemporaryFolder folder;
  std::shared_ptr<ScriptedMonitor> monitor = std::make_shared<ScriptedMonitor>();
  std::optional<MonitorPusher> pusher{
      std::in_place, PushOptions{},
      [monitor = monitor](const std::string& path, const auto& body) {
        return monitor->ask(path, body);
      },
      Duration::zero()};

  /// From now on an answer that was lost is asked for again.
  void be_patient() {
    pusher.emplace(
        PushOptions{},
        [monitor = monitor](const std::string& path, const auto& body) {
          return monitor->ask(path, body);
        },
        std::chrono::minutes(1));
  }
};

TEST_F(MonitorPusherTest, AMonitorThatStopsAnsweringLeavesThePushUnknown) {
  check("office.bhdl");
  pusher->push(false);
  monitor->answer("/api/push", MonitorAnswer{200, json{{"id", "7"}, {"state", "running"}}});
  monitor->answer("/api/pushes/7", Unanswered{{"timed out"}, true});
  const auto report = wait_for(Stage::kUnknown);
  EXPECT_EQ(report.title, "The monitor stopped answering");
  ASSERT_GE(report.lines.size(), 2u);
  EXPECT_EQ(report.lines[0].text, "Whether the program was pushed is not known.");
  EXPECT_EQ(report.lines[1].text, "timed out");
}

TEST_F(MonitorPusherTest, AProgramThatLacksAnIncludeIsNotSentToTheMonitor) {
  std::ofstream(folder.path() / "copy.bhdl") << "include \"office_states.bhdl\"\n";
  pusher->check({.file = folder.path() / "copy.bhdl"});
  const auto report = wait_for(Stage::kRefused);
  EXPECT_EQ(report.title, "Nothing was pushed");
  ASSERT_EQ(report.lines.size(), 3U);
  EXPECT_THAT(report.lines[1].text, HasSubstr("copy.bhdl:1:9: error: cannot read"));
  EXPECT_EQ(monitor->asked("/api/check"), 0);
}

TEST_F(MonitorPusherTest, AnOrderThatNobodyConfirmedMayHaveArrived) {
  check("office.bhdl");
  pusher->push(false);
  monitor->answer("/api/push", Unanswered{{"timed out"}, true});
  EXPECT_EQ(wait_for(Stage::kUnknown).stage, Stage::kUnknown);
}

TEST_F(MonitorPusherTest, AnOrderWhoseAnswerWasLostIsRepeatedWithItsId) {
  be_patient();
  check("office.bhdl");
  pusher->push(false);
  monitor->wait_for("/api/push");
  const auto id = monitor->last_body("/api/push").value("id", "");
  EXPECT_EQ(id.size(), 32U);
  monitor->answer("/api/push", Unanswered{{"timed out"}, true});
  monitor->answer("/api/push", Unanswered{{"connection refused"}});
  monitor->answer("/api/push", MonitorAnswer{503, json{{"detail", "It is only beginning."}}});
  monitor->wait_for("/api/push", 4);
  EXPECT_EQ(monitor->last_body("/api/push").value("id", ""), id);
  monitor->answer("/api/push", MonitorAnswer{200, json{{"id", id}, {"state", "running"}}});
  monitor->answer("/api/pushes/" + id, Unanswered{{"connection refused"}});
  monitor->answer("/api/pushes/" + id, MonitorAnswer{200, json{{"id", id}, {"state", "done"}}});
  EXPECT_EQ(wait_for(Stage::kDone).id, id);
}

TEST_F(MonitorPusherTest, AnotherPushHasAnotherId) {
  std::string before;
  for (int number = 1; number <= 2; ++number) {
    check("office.bhdl");
    pusher->push(false);
    monitor->answer("/api/push", MonitorAnswer{200, json{{"id", "7"}, {"state", "done"}}});
    EXPECT_EQ(wait_for(Stage::kDone).stage, Stage::kDone);
    const auto id = monitor->last_body("/api/push").value("id", "");
    EXPECT_NE(id, before);
    before = id;
  }
}

TEST_F(MonitorPusherTest, AnOrderThatCouldNotBeSentPushedNothing) {
  check("office.bhdl");
  pusher->push(false);
  monitor->answer("/api/push", Unanswered{{"connection refused"}});
  EXPECT_EQ(wait_for(Stage::kRefused).title, "Nothing was pushed");
}

TEST_F(MonitorPusherTest, OnlyTheAnswerOfTheNewestCheckCounts) {
  pusher->check({.file = file("first.bhdl")});
  monitor->wait_for("/api/check");
  pusher->cancel();
  pusher->check({.file = file("second.bhdl")});
  monitor->answer("/api/check", MonitorAnswer{200, json{{"ok", true}, {"hash", "11111111"}}});
  monitor->wait_for("/api/check", 2);  // so the first one's answer was handled
  EXPECT_EQ(pusher->report().stage, Stage::kChecking);
  pusher->push(false);
  EXPECT_EQ(pusher->report().stage, Stage::kChecking);  // nothing is checked that could be pushed
  monitor->answer("/api/check", MonitorAnswer{200, json{{"ok", true}, {"hash", "22222222"}}});
  EXPECT_THAT(wait_for(Stage::kReady).title, HasSubstr("second.bhdl 22222222"));
}

TEST_F(MonitorPusherTest, ACheckThatEndsAfterItWasCancelledIsForgotten) {
  pusher->check({.file = file("first.bhdl")});
  monitor->wait_for("/api/check");
  pusher->cancel();
  const int before = monitor->asked("/api/status");
  monitor->answer("/api/check", MonitorAnswer{200, json{{"ok", true}}});
  monitor->wait_for("/api/status", before + 1);  // which is asked when the check has ended
  EXPECT_EQ(pusher->report().stage, Stage::kNone);
  pusher->push(false);
  EXPECT_EQ(pusher->report().stage, Stage::kNone);
}

TEST_F(MonitorPusherTest, AnEarlierProgramIsListedReadAndChecked) {
  pusher->list();
  EXPECT_FALSE(pusher->pushes().is_known);
  monitor->answer("/api/pushes",
                  MonitorAnswer{200, json{{"pushes", json::array({json{{"hash", "3f2a91c0"}}})}}});
  wait_until([&] { return pusher->pushes().is_known; });
  ASSERT_EQ(pusher->pushes().pushes.size(), 1u);
  pusher->check({.hash = "3f2a91c0"});
  const json files = json::array({json{{"path", "office.bhdl"}, {"text", kProgram}}});
  monitor->answer("/api/pushed/3f2a91c0", MonitorAnswer{200, json{{"files", files}}});
  monitor->answer("/api/check", MonitorAnswer{200, json{{"ok", true}, {"hash", "3f2a91c0"}}});
  EXPECT_EQ(wait_for(Stage::kReady).title, "Push office.bhdl 3f2a91c0");
}

TEST_F(MonitorPusherTest, AChangedProgramIsPushedAtOnceInPlaceOfAnotherAndSaysWhy) {
  pusher->push_at_once({.robots = {"io"},
                        .files = {{"office.bhdl", kProgram}},
                        .reason = "search · gain of noise 1 → 2",
                        .replaces = "3f2a91c0"});
  EXPECT_EQ(pusher->report().stage, Stage::kPushing);
  monitor->answer("/api/push", MonitorAnswer{200, json{{"id", "7"}, {"state", "done"}}});
  EXPECT_EQ(wait_for(Stage::kDone).id, "7");
  const json request = monitor->last_body("/api/push");
  EXPECT_EQ(request["replaces"], "3f2a91c0");
  EXPECT_EQ(request["targets"], json::array({"io"}));
  EXPECT_THAT(request["author"].get<std::string>(), HasSubstr(" (search · gain of noise 1 → 2)"));
  EXPECT_EQ(monitor->asked("/api/check"), 0);
}

TEST_F(MonitorPusherTest, WhyTheListIsNotKnownIsTold) {
  pusher->list();
  monitor->answer("/api/pushes", Unanswered{{"connection refused"}});
  wait_until([&] { return !pusher->pushes().trouble.empty(); });
  EXPECT_EQ(pusher->pushes().trouble, "connection refused");
  EXPECT_FALSE(pusher->pushes().is_known);
}

TEST_F(MonitorPusherTest, QuittingDoesNotWaitForTheMonitor) {
  pusher->check({.file = file("office.bhdl")});
  monitor->wait_for("/api/check");
  pusher.reset();  // returns, though nobody answers
  monitor->answer("/api/check", MonitorAnswer{200, json{{"ok", true}}});
}

TEST_F(MonitorPusherTest, AFifoIsNoProgram) {
  const std::string path = folder.path() / "fifo.bhdl";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  pusher->check({.file = path});
  const auto report = wait_for(Stage::kRefused);
  ASSERT_EQ(report.lines.size(), 2U);
  EXPECT_EQ(report.lines[0].text, "the program cannot be read");
  EXPECT_THAT(report.lines[1].text, HasSubstr("it is a pipe, and no file"));
}

}  // namespace
}  // namespace galilean::monitor::top
