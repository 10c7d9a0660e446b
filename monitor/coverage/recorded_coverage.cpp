// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/coverage/recorded_coverage.h"

#include <array>
#include <string_view>
#include <utility>

#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/playback/known_type.h"

namespace galilean::monitor {

template <class Message, class Take>
void RecordedCoverage::decode(mcap::ByteView cdr, const Take& take_it) {
  Message message;
  if (msg::decode_cdr(cdr, message))
    take_it(message);
  else
    ++undecoded_;
}

template <class Note>
void RecordedCoverage::note(const std::string& hash, const Note& note_it) {
  auto* coverage = of(hash);
  if (!coverage) return;
  const auto before = coverage->kept_bytes();
  note_it(*coverage);
  kept_bytes_ += coverage->kept_bytes() - before;
}

void RecordedCoverage::begin(const mcap::Summary& summary) {
  constexpr std::array<std::pair<std::string_view, Kind>, 3> kTypes{
      {{msg::Program::kRosType, Kind::kProgram},
       {msg::RobotState::kRosType, Kind::kState},
       {msg::Transition::kRosType, Kind::kTransition}}};
  kinds_.clear();
  for (const auto& [id, channel] : summary.channels) {
    const auto schema = summary.schemas.find(channel.schema_id);
    if (schema == summary.schemas.end()) continue;
    for (const auto& [type, kind] : kTypes) {
      if (schema->second.name != type) continue;
      if (channel.message_encoding == "cdr" && known_type(schema->second))
        kinds_[id] = kind;
      else
        uncounted_.insert("what is on " + visible(channel.topic) +
                          " is not counted: its type is of another release");
    }
  }
}

void RecordedCoverage::take(const mcap::Message& message) {
  const auto kind = kinds_.find(message.channel_id);
  if (kind == kinds_.end()) return;
  switch (kind->second) {
    case Kind::kProgram:
      return decode<msg::Program>(message.data, [&](const auto& program) {
        note(program.hash, [&](auto& coverage) { coverage.describe(program); });
      });
    case Kind::kState:
      return decode<msg::RobotState>(message.data, [&](const auto& state) {
        note(state.program_hash, [&](auto& coverage) { coverage.note(state); });
      });
    case Kind::kTransition:
      return decode<msg::Transition>(message.data, [&](const auto& transition) {
        note(transition.program_hash, [&](auto& coverage) { coverage.note(transition); });
      });
  }
}

/// Returns nullptr for a robot that runs no program, and if there is too much.
ProgramCoverage* RecordedCoverage::of(const std::string& hash) {
  if (hash.empty()) return nullptr;
  if (kept_bytes_ > kMostKeptBytes) {
    uncounted_.insert("states and conditions beyond the first " +
                      std::to_string(kMostKeptBytes >> 20) + " MiB of them are not counted");
    return nullptr;
  }
  if (const auto known = programs_.find(hash); known != programs_.end()) return &known->second;
  if (programs_.size() == kMostPrograms) {
    uncounted_.insert("programs beyond the first " + std::to_string(kMostPrograms) +
                      " are not counted");
    return nullptr;
  }
  return &programs_[hash];
}

std::vector<std::string> RecordedCoverage::uncounted() const {
  std::vector<std::string> sentences(uncounted_.begin(), uncounted_.end());
  if (undecoded_ > 0)
    sentences.push_back(plural(undecoded_, "message") +
                        agreeing(undecoded_, " is not whole", " are not whole"));
  return sentences;
}

}  // namespace galilean::monitor
