// SPDX-License-Identifier: BSD-3-Clause
// The history is killed at each of two thousand writes. What it returned from is there, nothing is
// half, and what robots were sent is known to have been sent.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <string>

#include "core/wire/ros_time.h"
#include "monitor/pushes/history/history.h"
#include "monitor/pushes/history/push_messages.h"
#include "tests/monitor/pushes/faulty_disk.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
using Fate = FaultyDisk::Fate;

/// How far the process that is killed has come, in memory that outlives it. Each is the number of
/// the last push for which the call has returned.
struct Told {
  int added = 0, sent = 0, done = 0;
  bool failed = false;  ///< a call returned an error
};

msg::ProgramPush killed_push(int number) {
  msg::ProgramPush push;
  push.id = std::to_string(number);
  push.stamp = wire::ros_time(1'000'000'000LL * number);
  push.author = "balch";
  push.targets = {"io"};
  push.files = {{"main.bhdl", "text " + std::to_string(number)}, {"parts.bhdl", "parts"}};
  push.hash = hash_of_files(push);
  return push;
}

const std::vector<Step> kResting{{StepKind::kCheck, StepState::kDone},
                                 {StepKind::kTry, StepState::kLeftOut},
                                 {StepKind::kCanary, StepState::kLeftOut},
                                 {StepKind::kRest, StepState::kRunning}};

void push_until_killed(const fs::path& file, int first, Told& told) {
  auto history = History::open(file, {.reserve_bytes = 0});
  for (int number = first; history; ++number) {
    const auto id = std::to_string(number);
    if (!history.value()->add(killed_push(number))) break;
    told.added = number;
    const Progress resting{.state = PushState::kRunning, .steps = kResting};
    if (!history.value()->add_sending(id, resting, {"io"})) break;
    told.sent = number;  // from here on io may run it
    if (!history.value()->add_reply(id, {.robot = "io", .status = ReplyStatus::kRunning})) break;
    if (!history.value()->set_progress(id, {.state = PushState::kDone})) break;
    told.done = number;
  }
  told.failed = true;
  _exit(1);
}

class HistoryKillTest : public testing::Test {
 protected:
  HistoryKillTest()
      : told(*static_cast<Told*>(mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE,
                                      MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {}
  ~HistoryKillTest() override { munmap(&told, sizeof(Told)); }

  void kill_at(std::int64_t write, const fs::path& file, int first) {
    told = Told();
    const pid_t writer = fork();
    if (writer == 0) {
      disk.decide_by([write](std::int64_t now) {
        if (now < write) return Fate::kWritten;
        return write % 2 == 0 ? Fate::kDieHalfway : Fate::kDieBefore;
      });
      push_until_killed(file, first, told);
    }
    int status = 0;
    waitpid(writer, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it was not killed";
    ASSERT_EQ(WTERMSIG(status), SIGKILL);
    ASSERT_FALSE(told.failed);
  }

  /// Expects all that was told, and whole what was under way.
  void expect_kept(History& history, int first) const {
    for (int number = first; number <= std::max(told.added + 1, first); ++number) {
      const auto found = history.push(std::to_string(number));
      ASSERT_TRUE(found) << found.error().message;
      const auto& push = found.value();
      ASSERT_TRUE(push || number > told.added) << number << " was told to be there";
      if (!push) continue;
      EXPECT_EQ(push->hash, killed_push(number).hash);
      EXPECT_EQ(history.program(push->hash).value()->size(), 2U);
      if (number <= told.sent) {
        ASSERT_EQ(push->replies.size(), 1U);
      }
      if (number <= told.done) {
        EXPECT_EQ(push->replies[0].status, ReplyStatus::kRunning);
        EXPECT_EQ(push->progress.state, PushState::kDone);
      } else {
        EXPECT_NE(push->progress.state, PushState::kRunning) << "nobody brings it to an end";
      }
    }
  }

  /// Lets io tell that it runs what it was sent, if nobody knows that yet.
  void expect_told_later(History& history) const {
    if (told.sent == told.done) return;
    const auto before = history.push(std::to_string(told.sent)).value();
    if (before->progress.state == PushState::kDone) return;  // killed between write and return
    EXPECT_EQ(before->progress.state, PushState::kInterrupted);
    msg::ProgramReply reply;
    reply.id = before->id;
    reply.robot = "io";
    reply.hash = reply.running_hash = before->hash;
    reply.status = msg::ProgramReply_Constants::CONFIRMED;
    const auto marked = history.add_late_reply(reply);
    ASSERT_TRUE(marked && marked.value());
    EXPECT_EQ(marked.value()->progress.state, PushState::kToldLater);
    EXPECT_EQ(history.push(before->id).value()->progress.state, PushState::kToldLater);
  }

  Told& told;
  FaultyDisk disk{[](std::int64_t /*write*/) { return Fate::kWritten; }};
};

TEST_F(HistoryKillTest, LosesNothingThatItReturnedFromAtEachOf2000Writes) {
  constexpr int kFiles = 40, kKillsOfAFile = 50, kFarthest = 200;
  int kills = 0, sent = 0;
  for (int each = 0; each < kFiles; ++each) {
    const TemporaryFolder folder;
    const auto file = folder / "history.sqlite";
    int first = 1;
    for (int kill = 0; kill < kKillsOfAFile; ++kill, ++kills) {
      const int write = 1 + kills % kFarthest;
      SCOPED_TRACE("file " + std::to_string(each) + ", write " + std::to_string(write));
      kill_at(write, file, first);
      if (HasFatalFailure()) return;
      const auto history = History::open(file, {.reserve_bytes = 0});
      ASSERT_TRUE(history) << history.error().message;
      expect_kept(*history.value(), first);
      expect_told_later(*history.value());
      const auto verified = history.value()->verify();
      ASSERT_TRUE(verified) << verified.error().message;
      EXPECT_FALSE(verified.value().broken) << in_words(verified.value());
      if (HasFailure()) return;
      sent += told.sent > told.done ? 1 : 0;
      first = std::max(told.added + 1, first) + 1;
    }
  }
  EXPECT_EQ(kills, 2000);
  EXPECT_GE(sent, 200) << "too few were killed after the send for the rest to mean anything";
}

}  // namespace
}  // namespace galilean::monitor
