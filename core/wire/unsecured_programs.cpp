// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/unsecured_programs.h"

#include <dds/dds.h>

#include <string>

#include "core/visible_text.h"
#include "core/wire/announced.h"
#include "core/wire/security_log.h"

namespace galilean::wire {
namespace {

/// A GUID begins with the number of a vendor, which has no such bit (DDSI-RTPS 2.2, 8.2.4.2). One
/// of a program with keys has it (DDS Security 1.1, 9.3.3). Nobody is let in by it.
constexpr std::uint8_t kSecuredBit = 0x80;

void tell_if_unsecured(const dds_builtintopic_participant_t& program) {
  if ((program.key.v[0] & kSecuredBit) != 0) return;
  const auto name = announced_name(program.qos), address = announced_address(program.qos);
  const std::string who = name.empty() ? "a program" : "'" + visible(name) + "'";
  const std::string where = address.empty() ? "" : " (" + visible(address) + ")";
  tell_once(who + where +
            " has no keys, so that it neither hears this team nor is heard; start it "
            "with --secure");
}

/// Returns whether there may be more.
bool take_some(dds_entity_t reader) {
  constexpr int kAtOnce = 16;
  void* samples[kAtOnce] = {};
  dds_sample_info_t infos[kAtOnce];
  const int count = dds_take(reader, samples, infos, kAtOnce, kAtOnce);
  if (count <= 0) return false;
  for (int i = 0; i < count; ++i)
    if (infos[i].valid_data && infos[i].instance_state == DDS_ALIVE_INSTANCE_STATE)
      tell_if_unsecured(*static_cast<dds_builtintopic_participant_t*>(samples[i]));
  dds_return_loan(reader, samples, count);
  return count == kAtOnce;
}

/// Is called by Cyclone on the thread that discovers, as soon as it has kept a program out.
void look(dds_entity_t reader, void*) {
  end_unended_line();
  while (take_some(reader)) {
  }
}

}  // namespace

Entity tell_of_unsecured_programs(std::int32_t participant) {
  const dds_entity_t made =
      dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, nullptr, nullptr);
  if (made < 0) {
    tell_once(std::string("programs without keys are kept out, but not told (") +
              dds_strretcode(made) + ")");
    return {};
  }
  Entity reader(made);
  dds_listener_t* listener = dds_create_listener(nullptr);
  dds_lset_data_available(listener, look);
  dds_set_listener(reader.handle(), listener);
  dds_delete_listener(listener);
  look(reader.handle(), nullptr);  // who was there before
  return reader;
}

}  // namespace galilean::wire
