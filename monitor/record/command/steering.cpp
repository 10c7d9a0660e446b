// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/command/steering.h"

#include "core/account.h"

namespace galilean::monitor {

void Steering::greet() const {
  if (keys_.is_there()) setup_.say("keys: space pauses and goes on, q ends");
}

Result<void> Steering::obey() {
  if (auto done = obey_keys(keys_.read()); !done) return done;
  for (const auto& command : setup_.desk.take()) {
    auto done = Result<void>();
    if (command.kind == msg::Command_Constants::HOLD) done = pause(command.author);
    if (command.kind == msg::Command_Constants::RESUME) done = resume();
    if (!done) return done;
    obeyed_ = command.id;
    next_tell_ = Time{};
  }
  if (setup_.clock.now() >= next_tell_) tell();
  return {};
}

Result<void> Steering::obey_keys(const std::string& bytes) {
  for (const auto key : split_keys(bytes)) {
    if (key == "q") ended_ = true;
    if (key != " ") continue;
    if (auto done = setup_.recorder.paused() ? resume() : pause(user_name()); !done) return done;
  }
  return {};
}

Result<void> Steering::pause(const std::string& by) {
  if (setup_.recorder.paused()) return {};
  auto done = setup_.recorder.pause(by);
  if (!done) return done;
  next_tell_ = Time{};
  setup_.say(pause_text(*setup_.recorder.paused()) + "; " +
             (keys_.is_there() ? "space or 'galilean record resume' goes on"
                               : "'galilean record resume' goes on"));
  return {};
}

Result<void> Steering::resume() {
  const auto ended = setup_.recorder.resume();
  if (!ended) return ended.error();
  if (!ended.value()) return {};
  next_tell_ = Time{};
  setup_.say("goes on; " + pause_text(*ended.value()));
  return {};
}

void Steering::tell() {
  next_tell_ = setup_.clock.now() + RecorderDesk::kTellEach;
  const auto& paused = setup_.recorder.paused();
  const auto& files = setup_.files;
  RecorderStatus status;
  status.host = setup_.host;
  if (files.totals().files > 0) status.file = files.newest();
  if (paused) status.paused_since_ns = paused->from_ns;
  status.messages = files.totals().messages;
  status.missing = total_missing(setup_.recorder.recordings().losses());
  status.obeyed = obeyed_;
  setup_.desk.show(std::move(status));
}

}  // namespace galilean::monitor
