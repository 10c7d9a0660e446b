// SPDX-License-Identifier: BSD-3-Clause
#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/wire/announced.h"
#include "core/wire/delivery.h"
#include "core/wire/endpoints.h"
#include "core/wire/entity.h"
#include "core/wire/participant.h"
#include "core/wire/qos.h"
#include "core/wire/reader.h"
#include "core/wire/refusals.h"
#include "core/wire/schemas.h"
#include "core/wire/security.h"
#include "core/wire/untyped_topic.h"

namespace galilean::wire {
namespace {

struct FreeEndpoint {
  void operator()(dds_builtintopic_endpoint_t* endpoint) const {
    dds_builtintopic_free_endpoint(endpoint);
  }
};
using Endpoint = std::unique_ptr<dds_builtintopic_endpoint_t, FreeEndpoint>;

/// Returns the samples to Cyclone, even if the callback throws.
struct TakenSamples {
  std::span<ddsi_serdata*> samples;

  ~TakenSamples() {
    for (ddsi_serdata* sample : samples) ddsi_serdata_unref(sample);
  }
};

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

/// What the bounds of a type's fields allow in all may be far more than anybody sends.
constexpr std::size_t kMostMessageBytes = std::size_t{16} << 20;

/// Returns what discovery knows of the participant, in the domain of `member`.
std::optional<Sender> participant_of(dds_entity_t member, dds_instance_handle_t who) {
  const Entity participants(
      dds_create_reader(member, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, nullptr, nullptr));
  void* sample = nullptr;
  dds_sample_info_t info;
  if (dds_read_instance(participants.handle(), &sample, &info, 1, 1, who) != 1) return std::nullopt;
  const dds_qos_t* qos = static_cast<dds_builtintopic_participant_t*>(sample)->qos;
  Sender sender{announced_name(qos), announced_address(qos)};
  dds_return_loan(participants.handle(), &sample, 1);
  if (sender.name.empty()) return std::nullopt;
  return sender;
}

/// Errors: throws std::runtime_error if no message has that type.
UntypedTopic untyped_topic_of(const std::string& topic, const std::string& ros_type) {
  const auto* schema = find_schema_by_ros_type(ros_type);
  if (!schema) throw std::runtime_error("no message type is called " + ros_type);
  return {.name = topic, .dds_type = std::string(schema->dds_type)};
}

}  // namespace

Reader::Reader(Participant& participant, const std::string& topic, const std::string& ros_type,
               int depth)
    : topic_(topic), refusals_(&participant.refusals()), bounds_(bounds_of(ros_type)) {
  const auto qos = make_qos(delivery_of(ros_type));
  if (depth > 0) dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, depth);
  const auto of = participant.topic(topic, ros_type);
  if (of == 0) return;
  entity_ = Entity(
      permitted(dds_create_reader(participant.handle(), of, qos.get(), nullptr), "read", topic));
}

Reader::Reader(Participant& participant, const UntypedTopic& topic, const EndpointQos& asked,
               int depth)
    : topic_(topic.name), untyped_topic_(make_untyped_topic(participant, topic)) {
  if (untyped_topic_.handle() == 0) return;
  const auto qos = make_reader_qos(asked, depth);
  entity_ = Entity(permitted(
      dds_create_reader(participant.handle(), untyped_topic_.handle(), qos.get(), nullptr), "read",
      topic.name));
}

Reader::Reader(Participant& participant, const std::string& topic, const std::string& ros_type,
               Numbered)
    : topic_(topic),
      refusals_(&participant.refusals()),
      bounds_(bounds_of(ros_type)),
      untyped_topic_(make_untyped_topic(participant, untyped_topic_of(topic, ros_type))) {
  if (untyped_topic_.handle() == 0) return;
  const auto qos = make_qos(delivery_of(ros_type));
  entity_ = Entity(permitted(
      dds_create_reader(participant.handle(), untyped_topic_.handle(), qos.get(), nullptr), "read",
      topic));
}

Reader::~Reader() {
  if (callback_) dds_set_listener(entity_.handle(), nullptr);
}

bool Reader::admits(Received& received) const {
  if (!bounds_) return true;
  if (received.cdr.size() > kMostMessageBytes) {
    refusals_->note(topic_, "it has more than 16 MB");
    return false;
  }
  msg::CdrChecker checker(received.cdr);
  bounds_(checker);
  received.robot = checker.robot();
  if (checker.good()) return true;
  refusals_->note(topic_, checker.fault());
  return false;
}

void Reader::take(const std::function<void(const Received&)>& receive) {
  static_cast<void>(take_some(kAll, receive));
}

bool Reader::take_some(std::size_t most, const std::function<void(const Received&)>& receive) {
  return take_bytes(most, [&](const Received& received) {
    Received checked = received;
    if (admits(checked)) receive(checked);
  });
}

void Reader::take_unchecked(const std::function<void(const Received&)>& receive) {
  static_cast<void>(take_bytes(kAll, receive));
}

bool Reader::take_bytes(std::size_t most, const std::function<void(const Received&)>& receive) {
  if (entity_.handle() == 0) return false;
  constexpr std::size_t kAtOnce = 32;
  ddsi_serdata* samples[kAtOnce] = {};
  dds_sample_info_t infos[kAtOnce];
  std::vector<std::uint8_t> bytes;
  while (most > 0) {
    const auto wanted = static_cast<std::uint32_t>(std::min(most, kAtOnce));
    const auto count = dds_takecdr(entity_.handle(), samples, wanted, infos, DDS_ANY_STATE);
    if (count <= 0) return false;
    const TakenSamples taken{{samples, static_cast<std::size_t>(count)}};
    for (int i = 0; i < count; ++i) {
      if (infos[i].valid_data) {
        bytes.resize(ddsi_serdata_size(samples[i]));
        ddsi_serdata_to_ser(samples[i], 0, bytes.size(), bytes.data());
        receive({bytes, infos[i].source_timestamp, infos[i].publication_handle,
                 sequence_of(*samples[i])});
      }
    }
    most -= std::min(most, static_cast<std::size_t>(count));
  }
  return true;
}

void Reader::on_data(std::function<void()> callback) {
  callback_ = std::make_unique<std::function<void()>>(std::move(callback));
  dds_listener_t* listener = dds_create_listener(callback_.get());
  dds_lset_data_available(
      listener, [](dds_entity_t, void* call) { (*static_cast<std::function<void()>*>(call))(); });
  dds_set_listener(entity_.handle(), listener);
  dds_delete_listener(listener);
}

std::optional<Sender> Reader::sender(std::uint64_t writer) const {
  const Endpoint endpoint(dds_get_matched_publication_data(entity_.handle(), writer));
  if (!endpoint) return std::nullopt;
  return participant_of(dds_get_participant(entity_.handle()),
                        endpoint->participant_instance_handle);
}

std::string Reader::guid_of(std::uint64_t writer) const {
  const Endpoint endpoint(dds_get_matched_publication_data(entity_.handle(), writer));
  return endpoint ? hexadecimal(endpoint->key) : std::string();
}

bool Reader::matches(std::uint64_t writer) const {
  return Endpoint(dds_get_matched_publication_data(entity_.handle(), writer)) != nullptr;
}

int Reader::writers() const {
  dds_subscription_matched_status_t status{};
  dds_get_subscription_matched_status(entity_.handle(), &status);
  return static_cast<int>(status.current_count);
}

}  // namespace galilean::wire
