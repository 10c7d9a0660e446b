// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/wire_session.h"

#include <poll.h>

#include <utility>

#include "core/visible_text.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

constexpr Duration kDiscovery = std::chrono::seconds(3);
constexpr Duration kSettled = std::chrono::milliseconds(700);
constexpr int kLookAtDomainEach_ms = 50;

}  // namespace

Result<std::unique_ptr<WireSession>> WireSession::join(int domain, const std::string& name) {
  auto termination = std::make_unique<Termination>();  // before Cyclone's threads
  auto participant = wire::Participant::join(name, domain);
  if (!participant) return participant.error();
  return std::unique_ptr<WireSession>(
      new WireSession(std::move(participant).value(), std::move(termination)));
}

WireSession::WireSession(std::unique_ptr<wire::Participant> participant,
                         std::unique_ptr<Termination> termination)
    : owned_termination_(std::move(termination)),
      termination_(*owned_termination_),
      participant_(std::move(participant)),
      endpoints_(*participant_),
      definitions_(*participant_, [this] { return ended(); }) {}

std::vector<wire::EndpointInfo> WireSession::discover() {
  std::size_t count = 0;
  Time changed = now();
  wait(kDiscovery, [&] {
    const std::size_t known = endpoints_.known().size();
    if (known != std::exchange(count, known)) changed = now();
    return count > 0 && now() - changed > kSettled;
  });
  return endpoints_.known();
}

Result<FoundTopic> WireSession::find_now(const std::string& topic) {
  const auto known = endpoints_.known();
  std::vector<wire::EndpointInfo> writers, readers;
  for (const auto& end : known)
    if (names_topic(topic, end.topic)) (end.writes ? writers : readers).push_back(end);
  auto& ends = writers.empty() ? readers : writers;
  if (ends.empty()) return Error{unknown_topic(topic, known)};
  std::string name = ends.front().topic;
  std::erase_if(ends, [&](const wire::EndpointInfo& end) { return end.topic != name; });
  return FoundTopic{std::move(name), std::move(ends)};
}

Result<FoundTopic> WireSession::find(const std::string& topic) {
  wait(kDiscovery, [&] {
    for (const auto& endpoint : endpoints_.known())
      if (endpoint.writes && names_topic(topic, endpoint.topic)) return true;
    return false;
  });
  return find_now(topic);
}

std::unique_ptr<TopicReader> WireSession::read(FoundTopic topic) {
  auto reader =
      std::make_unique<TopicReader>(TopicReader::Wire{*participant_, endpoints_, definitions_},
                                    std::move(topic), [this] { wake_.ring(); });
  wake_.ring();  // because messages may have come before the callback was set
  return reader;
}

bool WireSession::wait(Duration most, const std::function<bool()>& enough) {
  for (const Time start = now(); !ended();) {
    wake_.clear();
    if (enough()) return true;
    if (now() - start >= most) return false;
    pollfd events[] = {{wake_.descriptor(), POLLIN, 0}, {termination_.descriptor(), POLLIN, 0}};
    poll(events, 2, kLookAtDomainEach_ms);
  }
  return false;
}

}  // namespace galilean::monitor
