// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/control/recorder_client.h"

#include <thread>
#include <utility>

#include "core/visible_text.h"
#include "monitor/record/control/recorder_desk.h"
#include "monitor/record/recorder_topics.h"

namespace galilean::monitor {
namespace {

constexpr Duration kLookAtRecordersEach = std::chrono::milliseconds(20);
constexpr Duration kSendCommandEach = std::chrono::milliseconds(250);
constexpr int kStatusesKept = 64;  // one topic carries those of several recorders

}  // namespace

RecorderClient::RecorderClient(wire::Participant& participant)
    : statuses_(participant, kRecorderStatusTopic, msg::DiagnosticArray::kRosType, kStatusesKept),
      commands_(participant, kRecorderCommandTopic) {}

bool RecorderClient::wait(Duration most, const std::function<bool()>& enough) {
  for (const Time start = clock_.now(); clock_.now() - start < most;) {
    if (enough()) return true;
    std::this_thread::sleep_for(kLookAtRecordersEach);
  }
  return enough();
}

void RecorderClient::listen() {
  statuses_.take([this](const wire::Received& received) {
    msg::DiagnosticArray message;
    if (!msg::decode_cdr(received.cdr, message)) return;
    if (auto status = read_status(message)) recorders_.note(std::move(*status), clock_.now());
  });
}

Result<RecorderStatus> RecorderClient::find(const std::string& name, Duration patience) {
  const auto heard = [&] {
    listen();
    return recorders_.find(name, clock_.now()).ok();
  };
  // Without a name, further recorders are heard within the time in which each tells how it is.
  if (wait(patience, heard) && name.empty())
    wait(RecorderDesk::kTellEach + kSendCommandEach, [this] {
      listen();
      return false;
    });
  const auto found = recorders_.find(name, clock_.now());
  if (!found) return found.error();
  return *found.value();
}

Result<RecorderStatus> RecorderClient::send(msg::Command command, const std::string& name,
                                            Duration patience) {
  command.targets = {name};
  const auto obeyed = [&] {
    listen();
    const auto found = recorders_.find(name, clock_.now());
    return found && found.value()->obeyed == command.id;
  };
  // Whether the recorder hears this writer yet cannot be known, so that the command is sent again.
  // A recorder takes an id once.
  for (const Time start = clock_.now(); clock_.now() - start < patience;) {
    static_cast<void>(commands_.write(command));
    if (wait(kSendCommandEach, obeyed)) return *recorders_.find(name, clock_.now()).value();
  }
  return Error{"the recorder '" + visible(name) + "' does not answer; it may be ending"};
}

}  // namespace galilean::monitor
