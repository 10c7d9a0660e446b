// SPDX-License-Identifier: BSD-3-Clause
// How a recorder is found and given commands.
#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "monitor/record/control/recorder_client.h"
#include "monitor/record/control/recorder_desk.h"
#include "tests/free_domain.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;

RecorderStatus status_of(const std::string& name) {
  RecorderStatus status;
  status.name = name;
  status.host = "lab3";
  status.file = name + ".mcap";
  status.messages = 5;
  return status;
}

TEST(RecorderStatus, IsReadAsItWasTold) {
  auto status = status_of("run");
  EXPECT_EQ(read_status(to_message(status, 7)), status);
  status.paused_since_ns = 1'500'000'000;
  status.missing = 3;
  status.obeyed = "17-5";
  const auto message = to_message(status, 7);
  EXPECT_EQ(read_status(message), status);
  EXPECT_EQ(message.status.at(0).level, 1);
  EXPECT_EQ(message.status.at(0).message, "paused since 1970-01-01T00:00:01.500Z");
}

TEST(RecorderStatus, OfSomethingElseIsNoStatus) {
  msg::DiagnosticArray message;
  EXPECT_FALSE(read_status(message).has_value());
  message.status.emplace_back().name = "io";
  EXPECT_FALSE(read_status(message).has_value());
}

TEST(Recorders, AreFoundByNameAndTheOnlyOneWithout) {
  const Time now{std::chrono::seconds(10)};
  Recorders recorders;
  EXPECT_THAT(recorders.find("", now).error().message, HasSubstr("no recorder is heard"));
  recorders.note(status_of("run"), now);
  EXPECT_EQ(recorders.find("", now).value()->name, "run");
  EXPECT_EQ(recorders.find("other", now).error().message,
            "the recorder 'other' is not heard; heard is run");
  recorders.note(status_of("other"), now);
  EXPECT_EQ(recorders.find("other", now).value()->name, "other");
  EXPECT_THAT(recorders.find("", now).error().message, HasSubstr("--name: other, run"));
  EXPECT_FALSE(recorders.find("run", now + Recorders::kSilentAfter + Duration(1)).ok());
}

/// A recorder that does nothing but obey.
class ObedientRecorder {
 public:
  ObedientRecorder(int domain, const std::string& name)
      : participant_(wire::Participant::join("record", domain).value()),
        desk_(*participant_, name),
        thread_([this] { run(); }) {}
  ~ObedientRecorder() {
    ended_ = true;
    thread_.join();
  }
  [[nodiscard]] int taken() const { return taken_; }

 private:
  void run() {
    RecorderStatus status = status_of("");
    while (!ended_) {
      for (const auto& command : desk_.take()) {
        ++taken_;
        status.obeyed = command.id;
        if (command.kind == msg::Command_Constants::HOLD) status.paused_since_ns = 1;
      }
      desk_.show(status);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  std::unique_ptr<wire::Participant> participant_;
  RecorderDesk desk_;
  std::atomic<bool> ended_{false};
  std::atomic<int> taken_{0};
  std::thread thread_;
};

TEST(RecorderClient, ACommandIsObeyedOnceByTheRecorderThatItNames) {
  const int domain = free_domain();
  const ObedientRecorder run(domain, "run"), other(domain, "other");
  const auto participant = wire::Participant::join("record-ctl", domain).value();
  RecorderClient client(*participant);
  ASSERT_TRUE(client.find("run", std::chrono::seconds(30)).ok());
  msg::Command command;
  command.id = "1";
  command.kind = msg::Command_Constants::HOLD;
  const auto answer = client.send(command, "run", std::chrono::seconds(30));
  ASSERT_TRUE(answer.ok()) << answer.error().message;
  EXPECT_TRUE(answer.value().paused_since_ns.has_value());
  EXPECT_TRUE(client.send(command, "run", std::chrono::seconds(30)).ok());
  EXPECT_EQ(run.taken(), 1);
  EXPECT_EQ(other.taken(), 0);
}

}  // namespace
}  // namespace galilean::monitor
