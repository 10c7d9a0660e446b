// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/namesakes.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/wire/announced.h"
#include "core/wire/builtin_topics.h"
#include "core/wire/participant.h"
#include "core/wire/qos.h"

namespace galilean::wire {
namespace {

Entity reader_of(const Participant& participant, dds_entity_t builtin_topic) {
  return Entity(checked(dds_create_reader(participant.handle(), builtin_topic, nullptr, nullptr),
                        "discovery"));
}

}  // namespace

struct Namesakes::State {
  struct NamedProcess {
    std::string guid, name;
  };

  struct Reading {
    std::string process_guid, topic;
  };

  static NamedProcess named_process(const dds_builtintopic_participant_t& sample) {
    return {hexadecimal(sample.key), announced_name(sample.qos)};
  }

  static Reading reading(const dds_builtintopic_endpoint_t& sample) {
    return {hexadecimal(sample.participant_key), sample.topic_name};
  }

  /// Returns what other processes know of this one.
  static NamedProcess this_process(const Participant& participant) {
    dds_guid_t guid;
    checked(dds_get_guid(participant.handle(), &guid), "the participant's GUID");
    const Qos qos(dds_create_qos());
    checked(dds_get_qos(participant.handle(), qos.get()), "the participant's name");
    return {hexadecimal(guid), announced_name(qos.get())};
  }

  Participant& participant;
  std::vector<std::string> topics;
  NamedProcess own;
  Entity process_reader;
  std::map<dds_instance_handle_t, NamedProcess> processes;
  /// Only while there are processes of this name, because a domain has many subscriptions.
  std::optional<Entity> subscription_reader;
  std::map<dds_instance_handle_t, Reading> readings;

  [[nodiscard]] std::set<std::string> namesakes() const {
    std::set<std::string> guids;
    for (const auto& [handle, process] : processes)
      if (process.name == own.name && process.guid != own.guid) guids.insert(process.guid);
    return guids;
  }
  void update_readings() {
    if (!subscription_reader)
      subscription_reader = reader_of(participant, DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION);
    take_changes(*subscription_reader, readings, reading);
  }
  void forget_readings() {
    subscription_reader.reset();
    readings.clear();
  }
  [[nodiscard]] bool reads_them(const std::string& process_guid) const {
    return std::ranges::any_of(readings, [&](const auto& each) {
      return each.second.process_guid == process_guid &&
             std::ranges::find(topics, each.second.topic) != topics.end();
    });
  }
};

Namesakes::Namesakes(Participant& participant, std::vector<std::string> topics)
    : state_(
          std::make_unique<State>(State{participant,
                                        std::move(topics),
                                        State::this_process(participant),
                                        reader_of(participant, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT),
                                        {},
                                        std::nullopt,
                                        {}})) {}

Namesakes::~Namesakes() = default;

int Namesakes::count() {
  take_changes(state_->process_reader, state_->processes, State::named_process);
  const auto namesakes = state_->namesakes();
  if (namesakes.empty()) {
    state_->forget_readings();
    return 0;
  }
  state_->update_readings();
  return static_cast<int>(std::ranges::count_if(
      namesakes, [this](const std::string& guid) { return state_->reads_them(guid); }));
}

}  // namespace galilean::wire
