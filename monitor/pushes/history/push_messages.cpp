// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/push_messages.h"

#include <random>

#include "bhdl/source/sha256.h"
#include "core/wire/ros_time.h"
#include "monitor/pushes/history/words.h"

namespace galilean::monitor {

std::string new_id() {
  std::random_device entropy;
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string id;
  for (int word = 0; word < 4; ++word)
    for (unsigned bits = entropy(), i = 0; i < 8; ++i, bits >>= 4) id += kDigits[bits & 15];
  return id;
}

std::string hash_of_files(const msg::ProgramPush& push) {
  std::vector<bhdl::SourceFile> files;
  for (const auto& file : push.files) files.push_back({file.path, file.text});
  return files.empty() ? std::string() : bhdl::program_hash(files);
}

msg::ProgramPush make_push(const bhdl::Program& program, const std::string& author,
                           const std::vector<std::string>& targets,
                           const std::string& replaces_hash) {
  msg::ProgramPush push;
  push.stamp = wire::ros_time(wire::wall_clock_ns());
  push.id = new_id();
  push.author = author;
  push.targets = targets;
  push.replaces_hash = replaces_hash;
  push.hash = program.hash;
  for (const auto& file : program.files) push.files.push_back({file.path, file.text});
  return push;
}

msg::PushProgress progress_message(const PushRecord& push) {
  msg::PushProgress message;
  message.stamp = wire::ros_time(wire::wall_clock_ns());
  message.id = push.id;
  message.author = push.author;
  message.program = push.program;
  message.hash = push.hash;
  message.targets = push.targets;
  message.state = to_text(push.progress.state);
  for (const auto& step : push.progress.steps)
    message.steps.push_back({to_text(step.kind), to_text(step.state), step.detail});
  return message;
}

}  // namespace galilean::monitor
