// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/participant.h"
#include "core/wire/discovery.h"
#include "core/wire/entity.h"
#include "core/wire/messages.h"

#include <dds/dds.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>
#include <sstream>
#include <utility>

#include "core/secure_folder.h"
#include "core/wire/announced.h"
#include "core/wire/lending.h"
#include "core/wire/qos.h"
#include "core/wire/refusals.h"
#include "core/wire/schemas.h"
#include "core/wire/security.h"
#include "core/wire/security_log.h"
#include "core/wire/unsecured_programs.h"

namespace galilean::wire {
namespace {

/// Returns Cyclone's settings. Cyclone tells the processes of a machine apart by their participant
/// index, which counts from 0 to MaxAutoParticipantIndex. The default of 9 is too low. 119 is the
/// highest that leaves the ports of the next domain alone (DDSI-RTPS 2.2, 9.6.1). The peer on
/// loopback finds the processes where there is no multicast. Cyclone's shared-memory mode is off.
/// Writers do not linger, because LingeringEntity has waited before. A secured program sends
/// messages to each member apart, because a revoked one would go on to hear what goes to a group.
std::string configuration(bool is_secured) {
  std::ostringstream peers;
  peers << "<Peer address=\"127.0.0.1\"/>";
  if (const char* listed = std::getenv("GALILEAN_PEERS")) {
    std::istringstream addresses(listed);
    for (std::string address; std::getline(addresses, address, ',');)
      if (!address.empty()) peers << "<Peer address=\"" << address << "\"/>";
  }
  std::string xml =
      "<Domain id=\"any\">" +
      std::string(is_secured ? "<General><AllowMulticast>spdp</AllowMulticast></General>" : "") +
      "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
      "<MaxAutoParticipantIndex>119</MaxAutoParticipantIndex><Peers>" +
      peers.str() +
      "</Peers></Discovery><SharedMemory><Enable>false</Enable></SharedMemory>"
      "<Internal><WriterLingerDuration>0 s</WriterLingerDuration></Internal></Domain>";
  if (const char* own = std::getenv("CYCLONEDDS_URI"); own && *own) xml += std::string(",") + own;
  return xml;
}

/// Errors: so few file descriptors may be open that Cyclone would end the process where it opens
/// its sockets.
Result<void> require_descriptors() {
  constexpr rlim_t kFewest = 64;
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= kFewest) return {};
  return Error{"only " + std::to_string(limit.rlim_cur) +
               " files and connections may be open at once, and DDS needs " +
               std::to_string(kFewest) + "; raise it with 'ulimit -n 1024'"};
}

Result<dds_domainid_t> domain_id(int domain) {
  long number = domain;
  if (domain < 0) {
    const char* given = std::getenv("ROS_DOMAIN_ID");
    if (!given || !*given) return dds_domainid_t{0};
    char* end = nullptr;
    number = std::strtol(given, &end, 10);
    if (*end)
      return Error{std::string("ROS_DOMAIN_ID is '") + given +
                   "'; it must be a number from 0 to 232"};
  }
  if (number < 0 || number > 232)
    return Error{"the DDS domain must be from 0 to 232, not " + std::to_string(number)};
  return static_cast<dds_domainid_t>(number);
}

/// Errors: DDS Security refuses the keys. The sentence says why.
Result<Entity> join_secured(dds_domainid_t domain, dds_qos_t& qos,
                            const std::filesystem::path& keys) {
  if (const auto secured = add_security(qos, keys); !secured) return secured.error();
  const JoiningLog log;
  const dds_entity_t participant = dds_create_participant(domain, &qos, nullptr);
  if (participant > 0) return Entity(participant);
  const auto line = log.first_line();
  return Error{"the keys in " + keys.string() + " do not open DDS domain " +
               std::to_string(domain) + ": " +
               (line.empty() ? std::string(dds_strretcode(participant)) : refusal_of(line))};
}

}  // namespace

Entity::~Entity() {
  if (handle_ > 0) dds_delete(handle_);
}

struct Participant::State {
  dds_domainid_t number = 0;
  Entity domain;
  Entity participant;
  Entity unsecured;  ///< tells of programs without keys; empty in a program that has none itself
  std::mutex mutex;
  std::map<std::string, Entity> topics;
  Refusals refusals;
};

Participant::Participant(std::unique_ptr<State> state) : state_(std::move(state)) {}

Participant::~Participant() {
  state_->unsecured = Entity();
  state_->topics.clear();
  state_->participant = Entity();
  state_->domain = Entity();
}

Result<std::unique_ptr<Participant>> Participant::join(const std::string& name, int domain) {
  const auto id = domain_id(domain);
  if (!id) return id.error();
  if (const auto enough = require_descriptors(); !enough) return enough.error();
  const auto keys = chosen_keys(name);
  if (!keys) return keys.error();
  if (keys.value() && id.value() > kLastSecuredDomain)
    return Error{"DDS domain " + std::to_string(id.value()) +
                 " cannot be secured; join one from 0 to " + std::to_string(kLastSecuredDomain)};
  auto state = std::make_unique<State>();
  state->number = id.value();
  // Cyclone refuses this if the process made the domain before. That domain then serves.
  const dds_entity_t made =
      dds_create_domain(id.value(), configuration(keys.value().has_value()).c_str());
  if (made > 0)
    state->domain = Entity(made);
  else if (made != DDS_RETCODE_PRECONDITION_NOT_MET)
    return Error{std::string("DDS cannot start (") + dds_strretcode(made) +
                 "); check CYCLONEDDS_URI and the network interfaces"};

  Qos qos(dds_create_qos());
  dds_qset_entity_name(qos.get(), name.c_str());
  if (keys.value()) {
    auto joined = join_secured(id.value(), *qos, *keys.value());
    if (!joined) return joined.error();
    state->participant = std::move(joined).value();
    state->unsecured = tell_of_unsecured_programs(state->participant.handle());
    return std::unique_ptr<Participant>(new Participant(std::move(state)));
  }
  const dds_entity_t participant = dds_create_participant(id.value(), qos.get(), nullptr);
  if (participant < 0)
    return Error{"DDS domain " + std::to_string(id.value()) + " cannot be joined (" +
                 dds_strretcode(participant) +
                 "); check that a network interface is up (loopback is enough) and that fewer than "
                 "120 processes are in it"};
  state->participant = Entity(participant);
  return std::unique_ptr<Participant>(new Participant(std::move(state)));
}

std::int32_t Participant::handle() const noexcept {
  return state_->participant.handle();
}

std::uint32_t Participant::domain() const noexcept {
  return state_->number;
}

Refusals& Participant::refusals() const noexcept {
  return state_->refusals;
}

std::int32_t Participant::topic(const std::string& name, const std::string& ros_type) {
  const std::lock_guard lock(state_->mutex);
  if (const auto found = state_->topics.find(name); found != state_->topics.end())
    return found->second.handle();
  const auto* descriptor = msg::descriptor_of(ros_type);
  const auto* schema = find_schema_by_ros_type(ros_type);
  if (!descriptor || !schema) throw std::runtime_error("no message type is called " + ros_type);
  dds_topic_descriptor_t ros_descriptor = *descriptor;
  ros_descriptor.m_typename = schema->dds_type.data();
  const auto qos = make_qos(delivery_of(ros_type));
  Entity entity(
      permitted(dds_create_topic(handle(), &ros_descriptor, name.c_str(), qos.get(), nullptr),
                "use topic", name));
  return state_->topics.emplace(name, std::move(entity)).first->second.handle();
}

struct Discovery::State {
  static constexpr int kAtOnce = 64;

  std::function<void()> changed;
  mutable std::mutex mutex;
  mutable std::map<dds_instance_handle_t, Publication> known;
  mutable std::deque<Publication> fresh;  ///< not yet returned by `take_new`
  bool is_followed = false;               ///< `take_new` was called
  Entity reader;  // last member, so that it is destroyed first: its thread calls `changed`

  void update() const {
    while (take_some() > 0) {
    }
  }
  /// Returns how many changes it took, at most kAtOnce.
  int take_some() const {
    void* samples[kAtOnce] = {};
    dds_sample_info_t infos[kAtOnce];
    const int count = dds_take(reader.handle(), samples, infos, kAtOnce, kAtOnce);
    if (count <= 0) return 0;
    for (int i = 0; i < count; ++i)
      note(*static_cast<dds_builtintopic_endpoint_t*>(samples[i]), infos[i]);
    dds_return_loan(reader.handle(), samples, count);
    return count;
  }
  void note(const dds_builtintopic_endpoint_t& endpoint, const dds_sample_info_t& info) const {
    if (info.instance_state != DDS_ALIVE_INSTANCE_STATE) {
      known.erase(info.instance_handle);
    } else if (info.valid_data) {
      const Publication publication{endpoint.topic_name, endpoint.type_name,
                                    hexadecimal(endpoint.key),
                                    hexadecimal(endpoint.participant_key)};
      const bool is_new = known.insert_or_assign(info.instance_handle, publication).second;
      if (is_new && is_followed) fresh.push_back(publication);
    }
  }
};

Discovery::Discovery(Participant& participant) : state_(std::make_unique<State>()) {
  state_->reader = Entity(checked(
      dds_create_reader(participant.handle(), DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr),
      "discovery"));
}

Discovery::~Discovery() {
  dds_set_listener(state_->reader.handle(), nullptr);
}

std::vector<Publication> Discovery::publications() const {
  const std::lock_guard lock(state_->mutex);
  state_->update();
  std::vector<Publication> result;
  for (const auto& [handle, publication] : state_->known) result.push_back(publication);
  return result;
}

Discovery::Fresh Discovery::take_new(std::size_t most) {
  const std::lock_guard lock(state_->mutex);
  auto& fresh = state_->fresh;
  if (!std::exchange(state_->is_followed, true))
    for (const auto& [handle, publication] : state_->known) fresh.push_back(publication);
  bool may_wait = true;
  for (std::size_t taken = 0; may_wait && taken < most && fresh.size() < most;
       taken += State::kAtOnce)
    may_wait = state_->take_some() == State::kAtOnce;
  const auto end = fresh.begin() + static_cast<std::ptrdiff_t>(std::min(most, fresh.size()));
  Fresh result{{fresh.begin(), end}, may_wait};
  fresh.erase(fresh.begin(), end);
  result.are_more = may_wait || !fresh.empty();
  return result;
}

void Discovery::on_change(std::function<void()> callback) {
  state_->changed = std::move(callback);
  dds_listener_t* listener = dds_create_listener(state_.get());
  dds_lset_data_available(listener,
                          [](dds_entity_t, void* state) { static_cast<State*>(state)->changed(); });
  dds_set_listener(state_->reader.handle(), listener);
  dds_delete_listener(listener);
}

}  // namespace galilean::wire
