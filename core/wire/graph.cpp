// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/graph.h"

#include "core/wire/announced.h"
#include "core/wire/builtin_topics.h"
#include "core/wire/entity.h"
#include "core/wire/qos.h"

namespace galilean::wire {

struct Graph::State {
  struct Process {
    std::string guid, name;
    static Process of(const dds_builtintopic_participant_t& sample) {
      return {hexadecimal(sample.key), announced_name(sample.qos)};
    }
  };
  struct Endpoint {
    std::string topic;
    std::string process;  ///< its participant's GUID
    static Endpoint of(const dds_builtintopic_endpoint_t& sample) {
      return {sample.topic_name, hexadecimal(sample.participant_key)};
    }
  };

  Entity process_reader, publication_reader, subscription_reader;
  std::map<dds_instance_handle_t, Process> processes;
  std::map<dds_instance_handle_t, Endpoint> publications, subscriptions;
};

Graph::Graph(Participant& participant) : state_(std::make_unique<State>()) {
  const auto open = [&](dds_entity_t topic) {
    return Entity(
        checked(dds_create_reader(participant.handle(), topic, nullptr, nullptr), "discovery"));
  };
  state_->process_reader = open(DDS_BUILTIN_TOPIC_DCPSPARTICIPANT);
  state_->publication_reader = open(DDS_BUILTIN_TOPIC_DCPSPUBLICATION);
  state_->subscription_reader = open(DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION);
}

Graph::~Graph() = default;

Graph::Topics Graph::topics() {
  State& now = *state_;
  take_changes(now.process_reader, now.processes, State::Process::of);
  take_changes(now.publication_reader, now.publications, State::Endpoint::of);
  take_changes(now.subscription_reader, now.subscriptions, State::Endpoint::of);

  std::map<std::string, std::string> names;
  for (const auto& [handle, process] : now.processes)
    names[process.guid] = process.name.empty() ? process.guid : process.name;
  const auto name_of = [&](const State::Endpoint& endpoint) {
    const auto found = names.find(endpoint.process);
    return found == names.end() ? endpoint.process : found->second;
  };
  Topics topics;
  for (const auto& [handle, writer] : now.publications)
    topics[writer.topic].writers.insert(name_of(writer));
  for (const auto& [handle, reader] : now.subscriptions)
    topics[reader.topic].readers.insert(name_of(reader));
  return topics;
}

}  // namespace galilean::wire
