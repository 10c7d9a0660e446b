// SPDX-License-Identifier: BSD-3-Clause
#include "tests/core/wire/types/foreign_talk.h"

#include <dds/dds.h>

#include <string>

#include "bare.h"
#include "core/wire/qos.h"
#include "foreign.h"
#include "tests/core/wire/types/foreign_samples.h"

namespace galilean::wire {
namespace {

const void* foreign_sample(Foreign message) {
  switch (message) {
    case Foreign::kPlain:
      return &plain_sample();
    case Foreign::kReport:
      return &report_sample();
    case Foreign::kSettings:
      return &settings_sample();
    case Foreign::kKeyed:
      return &keyed_sample();
    case Foreign::kLarge:
      return &large_sample();
    case Foreign::kCells:
      return &cells_sample();
    case Foreign::kRobotState:
      return &robot_state_sample();
    case Foreign::kBare:
      return &bare_sample();
  }
  return nullptr;
}

Qos writer_qos(Cdr version, const std::string& partition, Delivery delivery,
               std::chrono::nanoseconds latency_budget) {
  Qos qos = make_qos(delivery);
  const char* name = partition.c_str();
  if (!partition.empty()) dds_qset_partition(qos.get(), 1, &name);
  dds_qset_latency_budget(qos.get(), latency_budget.count());
  const dds_data_representation_id_t representation =
      version == Cdr::kFirst ? DDS_DATA_REPRESENTATION_XCDR1 : DDS_DATA_REPRESENTATION_XCDR2;
  dds_qset_data_representation(qos.get(), 1, &representation);
  return qos;
}

/// Returns Cyclone's settings for a domain that is called otherwise within this process.
std::string process_configuration(int domain) {
  return "<Domain id=\"any\"><Discovery><ExternalDomainId>" + std::to_string(domain) +
         "</ExternalDomainId><ParticipantIndex>auto</ParticipantIndex>"
         "<MaxAutoParticipantIndex>119</MaxAutoParticipantIndex>"
         "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery>"
         "<SharedMemory><Enable>false</Enable></SharedMemory></Domain>";
}

constexpr dds_domainid_t kFirstForeignDomain = 1000;

}  // namespace

const dds_topic_descriptor& foreign_descriptor(Foreign message) {
  switch (message) {
    case Foreign::kPlain:
      return foreign_Plain_desc;
    case Foreign::kReport:
      return foreign_Report_desc;
    case Foreign::kSettings:
      return foreign_Settings_desc;
    case Foreign::kKeyed:
      return foreign_Keyed_desc;
    case Foreign::kLarge:
      return foreign_Large_desc;
    case Foreign::kCells:
      return foreign_msgs_msg_Cells_desc;
    case Foreign::kRobotState:
      return other_RobotState_desc;
    case Foreign::kBare:
      break;
  }
  return bare_Message_desc;
}

std::string foreign_type(Foreign message) {
  return message == Foreign::kRobotState ? "galilean_msgs::msg::dds_::RobotState_"
                                         : foreign_descriptor(message).m_typename;
}

ForeignTalk::ForeignTalk(std::int32_t participant, Foreign message, const std::string& topic,
                         Cdr version, const std::string& partition, Delivery delivery,
                         std::chrono::nanoseconds latency_budget)
    : message_(message) {
  const auto qos = writer_qos(version, partition, delivery, latency_budget);
  const std::string type = foreign_type(message);
  dds_topic_descriptor_t descriptor = foreign_descriptor(message);
  descriptor.m_typename = type.c_str();
  topic_ = Entity(
      checked(dds_create_topic(participant, &descriptor, topic.c_str(), nullptr, nullptr), topic));
  writer_ =
      Entity(checked(dds_create_writer(participant, topic_.handle(), qos.get(), nullptr), topic));
}

bool ForeignTalk::write() {
  return dds_write(writer_.handle(), foreign_sample(message_)) == DDS_RETCODE_OK;
}

bool ForeignTalk::dispose() {
  return dds_dispose(writer_.handle(), foreign_sample(message_)) == DDS_RETCODE_OK;
}

int ForeignTalk::readers() const {
  dds_publication_matched_status_t status{};
  dds_get_publication_matched_status(writer_.handle(), &status);
  return static_cast<int>(status.current_count);
}

bool ForeignTalk::arrived() const {
  return dds_wait_for_acks(writer_.handle(), DDS_SECS(10)) == DDS_RETCODE_OK;
}

ForeignProcess::ForeignProcess(const std::string& name, int domain) {
  const auto id = kFirstForeignDomain + static_cast<dds_domainid_t>(domain);
  domain_ = Entity(checked(dds_create_domain(id, process_configuration(domain).c_str()), name));
  const Qos qos(dds_create_qos());
  dds_qset_entity_name(qos.get(), name.c_str());
  participant_ = Entity(checked(dds_create_participant(id, qos.get(), nullptr), name));
}

}  // namespace galilean::wire
