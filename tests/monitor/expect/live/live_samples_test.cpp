// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/live/live_samples.h"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <atomic>
#include <cstdio>
#include <fstream>
#include <thread>

#include "core/wire/writer.h"
#include "monitor/expect/judge/judge.h"
#include "monitor/expect/language/parser.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"
#include "tests/temporary_folder.h"

namespace galilean::expect {
namespace {

using testing::HasSubstr;

/// A robot that sends its state whenever it is asked to.
class LiveRobot {
 public:
  explicit LiveRobot(int domain) : participant_(wire::Participant::join("io", domain).value()) {
    state_.robot = "io";
    state_.state = "wander";
  }
  void send() {
    ++state_.tick;
    EXPECT_TRUE(writer_.write(state_));
  }

 private:
  std::unique_ptr<wire::Participant> participant_;
  wire::Writer<msg::RobotState> writer_{*participant_, "rt/io/state"};
  msg::RobotState state_;
};

TEST(LiveSamples, GivesTheJudgeWhatIsSentNow) {
  const int domain = free_domain();
  const auto session = monitor::WireSession::join(domain, "check").value();
  LiveRobot robot(domain);
  const auto parsed = parse("a.expect",
                            "io: never state is \"wander\", count of messages of "
                            "/io/state >= 3, always /io/state.tick > 0\n"
                            "europa: always it is healthy\n");
  ASSERT_TRUE(parsed.ok());
  Judge judge(parsed.expectations);
  LiveSamples samples(*session, judge);
  int rounds = 0;
  EXPECT_TRUE(wire::wait_until([&] {
    robot.send();
    samples.pump();
    return samples.first() && ++rounds > 200;
  }));
  const auto played = samples.finish();
  EXPECT_LT(played.begin_ns, played.end_ns);
  EXPECT_EQ(played.undecoded, 0U);
  EXPECT_GE(played.messages, 3U);
  const auto verdicts = judge.finish(played.begin_ns, played.end_ns).verdicts;
  ASSERT_EQ(verdicts.size(), 4U);
  EXPECT_EQ(verdicts[0].finding.outcome, Outcome::kFails);
  EXPECT_EQ(verdicts[1].finding.outcome, Outcome::kHolds);
  EXPECT_EQ(verdicts[2].finding.outcome, Outcome::kHolds);
  EXPECT_EQ(verdicts[3].finding.outcome, Outcome::kCannotTell);
}

TEST(LiveSamples, EndsWhenItsTimeIsOverThoughNobodySends) {
  const auto session = monitor::WireSession::join(free_domain(), "check").value();
  const auto parsed = parse("a.expect", "every robot: always it is healthy");
  Judge judge(parsed.expectations);
  const auto played = listen(*session, judge, from_seconds(0.2));
  EXPECT_EQ(played.messages, 0U);
  EXPECT_GE(played.end_ns - played.begin_ns, 200'000'000);
}

TEST(LiveCheck, JudgesTheTeamThatRuns) {
  const int domain = free_domain();
  const TemporaryFolder folder;
  std::ofstream(folder / "a.expect") << "io: always it is healthy\n";
  LiveRobot robot(domain);
  std::atomic<bool> over{false};
  std::thread sending([&] {
    while (!over) {
      robot.send();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
  const std::string command = "'" GALILEAN_LOG_CHECK "' --live --for 500ms --domain " +
                              std::to_string(domain) + " --expect '" +
                              (folder / "a.expect").string() + "' 2>&1";
  FILE* output = popen(command.c_str(), "r");
  std::string text;
  for (int letter; (letter = std::fgetc(output)) != EOF;) text += static_cast<char>(letter);
  over = true;
  sending.join();
  EXPECT_EQ(WEXITSTATUS(pclose(output)), 0) << text;
  EXPECT_THAT(text, HasSubstr("ok     io: always it is healthy"));
  EXPECT_THAT(text, HasSubstr("1 holds"));
}

}  // namespace
}  // namespace galilean::expect
