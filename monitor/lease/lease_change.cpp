// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/lease/lease_change.h"

namespace galilean::monitor {

std::string_view name_of(LeaseChange::Kind kind) noexcept {
  switch (kind) {
    case LeaseChange::Kind::kTaken:
      return "taken";
    case LeaseChange::Kind::kAsked:
      return "asked";
    case LeaseChange::Kind::kGiven:
      return "given";
    case LeaseChange::Kind::kRefused:
      return "refused";
    case LeaseChange::Kind::kTakenOver:
      return "taken_over";
    case LeaseChange::Kind::kUnanswered:
      return "unanswered";
    case LeaseChange::Kind::kReleased:
      return "released";
    case LeaseChange::Kind::kWithdrawn:
      return "withdrawn";
    case LeaseChange::Kind::kSilent:
      return "silent";
  }
  return "";
}

std::string in_words(const LeaseChange& change) {
  const std::string& by = change.by.name;
  const std::string& other = change.other.name;
  const std::string why = change.reason.empty() ? "" : ": " + change.reason;
  const std::string heir = other.empty() ? "nobody holds it now" : other + " holds it now";
  switch (change.kind) {
    case LeaseChange::Kind::kTaken:
      return by + " holds it now" + why;
    case LeaseChange::Kind::kAsked:
      return by + " asks " + other + " for it" + why;
    case LeaseChange::Kind::kGiven:
      return by + " gave it to " + other + why;
    case LeaseChange::Kind::kRefused:
      return by + " did not give it to " + other + why;
    case LeaseChange::Kind::kTakenOver:
      return by + " took it over from " + other + why;
    case LeaseChange::Kind::kUnanswered:
      return by + " holds it now, because " + other + " did not answer";
    case LeaseChange::Kind::kReleased:
      return by + " let it go; " + heir;
    case LeaseChange::Kind::kWithdrawn:
      return by + " does not ask " + other + " for it any more";
    case LeaseChange::Kind::kSilent:
      return by + " says nothing any more; " + heir;
  }
  return {};
}

}  // namespace galilean::monitor
