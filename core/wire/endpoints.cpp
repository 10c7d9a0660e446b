// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/endpoints.h"

#include <algorithm>
#include <string_view>
#include <tuple>

#include "core/wire/announced.h"
#include "core/wire/builtin_topics.h"
#include "core/wire/qos.h"
#include "core/wire/type_hash.h"
#include "core/wire/unwrapped.h"

namespace galilean::wire {
namespace {

constexpr std::string_view kBuiltinTypes = "org::eclipse::cyclonedds::builtin::";

EndpointQos endpoint_qos(const dds_qos_t* qos) {
  EndpointQos found;
  dds_reliability_kind_t reliability{};
  dds_durability_kind_t durability{};
  dds_ownership_kind_t ownership{};
  dds_history_kind_t history{};
  dds_duration_t duration = 0;
  std::int32_t depth = 0;
  if (dds_qget_reliability(qos, &reliability, &duration))
    found.reliable = reliability == DDS_RELIABILITY_RELIABLE;
  if (dds_qget_durability(qos, &durability))
    found.durability = static_cast<EndpointQos::Durability>(durability);
  if (dds_qget_ownership(qos, &ownership)) found.exclusive = ownership == DDS_OWNERSHIP_EXCLUSIVE;
  if (dds_qget_deadline(qos, &duration)) found.deadline_ns = duration;
  if (dds_qget_history(qos, &history, &depth))
    found.depth = history == DDS_HISTORY_KEEP_ALL ? 0 : depth;
  return found;
}

std::string published_type_hash(const dds_builtintopic_endpoint_t& sample) {
  auto& endpoint = const_cast<dds_builtintopic_endpoint_t&>(sample);  // Cyclone only reads it
  const dds_typeinfo_t* info = nullptr;
  if (dds_builtintopic_get_endpoint_type_info(&endpoint, &info) != DDS_RETCODE_OK || !info)
    return {};
  return type_hash(unwrapped(*ddsi_typeinfo_complete_typeid(info)));
}

/// The last byte of a GUID is the kind of the endpoint (DDSI-RTPS 2.2, 9.3.1.2).
bool has_keys(const dds_guid_t& guid) {
  constexpr std::uint8_t kKind = 0x0F, kWriterWithKey = 2, kReaderWithKey = 7;
  const auto kind = guid.v[sizeof guid.v - 1] & kKind;
  return kind == kWriterWithKey || kind == kReaderWithKey;
}

/// Its process is the participant's GUID.
template <bool kWrites>
EndpointInfo endpoint_of(const dds_builtintopic_endpoint_t& sample) {
  return {.writes = kWrites,
          .topic = sample.topic_name,
          .dds_type = sample.type_name,
          .process = hexadecimal(sample.participant_key),
          .qos = endpoint_qos(sample.qos),
          .type_hash = published_type_hash(sample),
          .keyed = has_keys(sample.key),
          .guid = hexadecimal(sample.key)};
}

}  // namespace

struct Endpoints::State {
  struct Process {
    std::string guid, name;
    static Process of(const dds_builtintopic_participant_t& sample) {
      return {hexadecimal(sample.key), announced_name(sample.qos)};
    }
  };

  Entity process_reader, publication_reader, subscription_reader;
  std::map<dds_instance_handle_t, Process> processes;
  std::map<dds_instance_handle_t, EndpointInfo> publications, subscriptions;
};

Endpoints::Endpoints(Participant& participant) : state_(std::make_unique<State>()) {
  const auto open = [&](dds_entity_t topic) {
    return Entity(
        checked(dds_create_reader(participant.handle(), topic, nullptr, nullptr), "discovery"));
  };
  state_->process_reader = open(DDS_BUILTIN_TOPIC_DCPSPARTICIPANT);
  state_->publication_reader = open(DDS_BUILTIN_TOPIC_DCPSPUBLICATION);
  state_->subscription_reader = open(DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION);
}

Endpoints::~Endpoints() = default;

std::vector<EndpointInfo> Endpoints::known() {
  State& now = *state_;
  take_changes(now.process_reader, now.processes, State::Process::of);
  take_changes(now.publication_reader, now.publications, endpoint_of<true>);
  take_changes(now.subscription_reader, now.subscriptions, endpoint_of<false>);

  std::map<std::string, std::string> names;
  for (const auto& [handle, process] : now.processes)
    if (!process.name.empty()) names[process.guid] = process.name;
  std::vector<EndpointInfo> endpoints;
  for (const auto* side : {&now.publications, &now.subscriptions})
    for (auto [handle, endpoint] : *side) {
      if (endpoint.dds_type.starts_with(kBuiltinTypes)) continue;
      if (const auto name = names.find(endpoint.process); name != names.end())
        endpoint.process = name->second;
      endpoint.handle = handle;
      endpoints.push_back(std::move(endpoint));
    }
  std::ranges::sort(endpoints, {}, [](const EndpointInfo& endpoint) {
    return std::tie(endpoint.topic, endpoint.process);
  });
  return endpoints;
}

}  // namespace galilean::wire
