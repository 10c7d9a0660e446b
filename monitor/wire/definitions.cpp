// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/definitions.h"

#include <array>

#include "core/clock.h"
#include "core/visible_text.h"
#include "core/wire/types/own_types.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

constexpr Duration kPatience = std::chrono::seconds(3);
constexpr Duration kAskAgain = std::chrono::seconds(1);

Error undecodable(const wire::EndpointInfo& end, const std::string& why) {
  return Error{"messages of " + visible(end.process) + " on '" + visible(shown_topic(end.topic)) +
               "' cannot be decoded: " + why +
               "; 'galilean rate' and 'galilean info' work all the same"};
}

Error no_definition(const wire::EndpointInfo& end) {
  return undecodable(end, visible(end.process) +
                              " publishes no type information, and Galilean does not define " +
                              visible(shown_type(end.dds_type)) +
                              "; use 'ros2 topic echo', or a DDS layer that publishes type "
                              "information, which rmw_cyclonedds does not");
}

Error bad_definition(const wire::EndpointInfo& end, const std::string& clause) {
  return undecodable(end, "their type, " + visible(shown_type(end.dds_type)) + ", " + clause);
}

}  // namespace

Definition definition_of(const wire::EndpointInfo& end) {
  if (end.type_hash.empty()) return Definition::kUnpublished;
  const auto* own = wire::find_own_type(end.dds_type);
  if (!own) return Definition::kOwn;
  return own->hash == end.type_hash ? Definition::kOurs : Definition::kOther;
}

std::string definition_word(Definition definition) {
  constexpr std::array kWords{"ours", "differs", "its own", "unpublished"};
  return kWords.at(static_cast<std::size_t>(definition));
}

Result<wire::Type> Definitions::find(const wire::EndpointInfo& end) {
  const auto* own = wire::find_own_type(end.dds_type);
  if (own && (end.type_hash.empty() || end.type_hash == own->hash)) return own->description;
  if (end.type_hash.empty()) return no_definition(end);
  const auto failed = failures_.find(end.type_hash);
  const bool again = failed != failures_.end();
  const Time start = clock_.now();
  if (again && start - failed->second.asked < kAskAgain)
    return bad_definition(end, failed->second.clause);
  const Duration patience = again ? Duration(0) : kPatience;
  auto type =
      finder_.find(end.type_hash, [&] { return ended_() || clock_.now() - start > patience; });
  if (type) return type;
  failures_[end.type_hash] = {type.error().message, clock_.now()};
  return bad_definition(end, type.error().message);
}

}  // namespace galilean::monitor
