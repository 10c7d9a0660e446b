// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/inputs_publisher.h"

#include <utility>

#include "core/wire/topic_names.h"

namespace galilean::robot {
namespace {

constexpr Duration kInputsPause = std::chrono::milliseconds(10);
/// Discovery takes less than a second on a quiet network.
constexpr Duration kStartKept = std::chrono::seconds(10);
constexpr Duration kMemoryEach = std::chrono::seconds(10);
/// What may wait for slow readers: half a minute of a robot that sees ten pictures a second. The
/// tap counts the ticks beyond.
constexpr std::size_t kMostBytes = 32'000'000;

std::size_t bytes_of(const msg::TickInputs& inputs) {
  std::size_t bytes = sizeof inputs + inputs.picture.size() +
                      inputs.outcome.variables.size() * sizeof(std::uint64_t);
  for (const auto& memory : inputs.memory) bytes += memory.packed.size();
  for (const auto& program : inputs.program)
    for (const auto& file : program.files) bytes += file.text.size();
  return bytes;
}

InputsComposer::Source source_of(const TelemetrySource& source) {
  return {.robot = source.robot,
          .seed = source.executive.seed(),
          .description = [&executive =
                              source.executive](ProgramId id) { return executive.description(id); },
          .break_table = [&executive = source.executive](
                             std::uint64_t number) { return executive.breaks().table(number); }};
}

}  // namespace

InputsPublisher::InputsPublisher(const TelemetrySource& source, InputsTap& tap,
                                 Worker::Report report)
    : tap_(tap),
      clock_(source.clock),
      began_(source.clock.now()),
      wall_(source.clock),
      compose_(source_of(source)),
      participant_(source.participant),
      topic_(wire::robot_topic(source.robot, "inputs")),
      writer_(std::in_place, participant_, topic_),
      next_memory_(began_ + kMemoryEach) {
  worker_ = Worker(
      [this](const std::stop_token& stop) {
        look();
        sleep_for(kInputsPause, stop);
        if (stop.stop_requested()) look();
      },
      std::move(report));
}

void InputsPublisher::look() {
  const bool is_read = writer_->readers() > 0;
  if (!is_read && clock_.now() - began_ > kStartKept) return forget();
  tap_.want(true);
  if (clock_.now() >= next_memory_) ask_for_memory();
  collect();
  if (is_read) send();
}

void InputsPublisher::collect() {
  wall_.refresh();
  while (waiting_bytes_ < kMostBytes) {
    msg::TickInputs next;
    if (!compose_.take(tap_, next)) return;
    next.stamp = wall_.stamp(Time(Duration(next.now_ns)));
    waiting_bytes_ += bytes_of(next);
    waiting_.push_back(std::move(next));
  }
}

/// What DDS does not take in time stays the next to be sent.
void InputsPublisher::send() {
  while (!waiting_.empty() && writer_->write(waiting_.front())) {
    wrote_ = true;
    waiting_bytes_ -= bytes_of(waiting_.front());
    waiting_.pop_front();
  }
}

void InputsPublisher::forget() {
  tap_.want(false);
  for (TickRecord record; tap_.take(record);) {
  }
  waiting_.clear();
  waiting_bytes_ = 0;
  compose_.begin_anew();
  next_memory_ = Time{};  // the next reader begins with it
  if (!std::exchange(wrote_, false)) return;
  writer_.reset();  // with what it keeps for late joiners, who would get ticks of long ago
  writer_.emplace(participant_, topic_);
}

void InputsPublisher::ask_for_memory() {
  tap_.want_memory();
  next_memory_ = clock_.now() + kMemoryEach;
}

}  // namespace galilean::robot
