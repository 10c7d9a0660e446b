// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "monitor/logs/reading/selection.h"
#include "tests/monitor/expect/recording/recorded_team.h"
#include "tests/temporary_folder.h"

namespace galilean::logs {

/// What a command printed, and its exit code.
struct Answer {
  int code = -1;
  std::string out, errors;
};

template <class Run>
Answer answer_of(Run run) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Answer answer;
  answer.code = run();
  answer.out = testing::internal::GetCapturedStdout();
  answer.errors = testing::internal::GetCapturedStderr();
  return answer;
}

/// Recordings of a robot in a folder of the test's own.
class LoggedTeam : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  void write(const std::string& name, const mcap::Bytes& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  [[nodiscard]] mcap::Bytes read(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// Six seconds of io, ten states and ten variables a second. Its x is the time.
  [[nodiscard]] static mcap::Bytes six_seconds() {
    expect::RecordedTeam team;
    for (int i = 0; i < 60; ++i) {
      msg::RobotState state;
      state.robot = "io";
      state.state = i < 30 ? "wander" : "stuck";
      state.tick = static_cast<std::uint64_t>(i);
      state.x_m = 0.1 * i;
      team.send(0.1 * i, "/io/state", state);
      msg::Variables variables;
      variables.robot = "io";
      for (int v = 0; v <= i / 30; ++v)
        variables.items.emplace_back().name = "v," + std::to_string(v);
      team.send(0.1 * i, "/io/variables", variables);
    }
    return team.end();
  }

  TemporaryFolder folder_;
};

/// Returns the messages of a recording as topics, times and contents.
inline std::vector<std::tuple<std::string, std::uint64_t, std::uint32_t, mcap::Bytes>> contents_of(
    const std::string& path) {
  std::vector<std::tuple<std::string, std::uint64_t, std::uint32_t, mcap::Bytes>> all;
  const auto recording = Recording::open(path, mcap::Depth::kAll);
  if (!recording) {
    ADD_FAILURE() << recording.error().message;
    return all;
  }
  EXPECT_FALSE(recording.value().summary().recovered()) << path;
  auto messages = SelectedMessages::of(recording.value(), {});
  while (const auto* message = messages.value().next())
    all.emplace_back(recording.value().summary().channels.at(message->channel_id).topic,
                     message->log_ns, message->sequence,
                     mcap::Bytes(message->data.begin(), message->data.end()));
  return all;
}

}  // namespace galilean::logs
