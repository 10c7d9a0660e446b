// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/refusal.h"

#include <array>
#include <ctime>
#include <string_view>
#include <utility>

#include "core/cut_text.h"
#include "monitor/pushes/history/json.h"
#include "monitor/pushes/history/words.h"

namespace galilean::monitor {
namespace {

using Reason = Refusal::Reason;

/// How the history tells a reason. The words in its file never change.
constexpr std::array<std::pair<Reason, std::string_view>, 4> kReasons{
    {{Reason::kNotFound, "not_found"},
     {Reason::kConflict, "conflict"},
     {Reason::kBroken, "broken"},
     {Reason::kUnavailable, "unavailable"}}};

std::string short_hash(const std::string& hash) {
  return std::string(cut_text(hash, 8));
}

std::string clock_time(std::int64_t since_epoch_ns) {
  const std::time_t seconds = since_epoch_ns / 1'000'000'000;
  std::tm local{};
  localtime_r(&seconds, &local);
  char text[16];
  return std::string(text, std::strftime(text, sizeof text, "%H:%M:%S", &local));
}

std::string audience(const PushRecord& push) {
  if (push.targets.empty()) return "the team";
  std::string names;
  for (const auto& name : push.targets) names += (names.empty() ? "" : ", ") + name;
  return names;
}

/// Returns a text such as "office_cleanup.bhdl (1a2b3c4d)".
std::string program_words(const PushRecord& push) {
  return push.program + (push.hash.empty() ? "" : " (" + short_hash(push.hash) + ")");
}

/// Returns which program runs, and who pushed it. `by` is the push that brought it.
std::string origin(const std::string& hash, const std::optional<PushRecord>& by) {
  return by ? program_words(*by) + ", which " + by->author + " pushed at " +
                  clock_time(by->pushed_ns)
            : short_hash(hash) + ", which was not pushed through this monitor";
}

}  // namespace

Refusal not_found(std::string message) {
  return {.reason = Refusal::Reason::kNotFound, .message = std::move(message)};
}

Refusal conflict(std::string message) {
  return {.reason = Refusal::Reason::kConflict, .message = std::move(message)};
}

Refusal unavailable(std::string message) {
  return {.reason = Refusal::Reason::kUnavailable, .message = std::move(message)};
}

Refusal cannot_now(const std::string& why) {
  return unavailable("The monitor cannot do this now: " + why + ".");
}

Refusal under_way(const PushRecord& other, const std::string& running_hash,
                  const std::optional<PushRecord>& by) {
  auto refusal =
      conflict(other.author + " is pushing " + program_words(other) + " to " + audience(other) +
               " since " + clock_time(other.pushed_ns) + "; wait for its end, or cancel it." +
               (running_hash.empty() ? "" : " Now runs " + origin(running_hash, by) + "."));
  refusal.pushed = other;
  if (!running_hash.empty()) refusal.running_hash = running_hash;
  refusal.running_pushed = by;
  return refusal;
}

Refusal replaced_meanwhile(const std::string& replaces, const Stale& stale,
                           const std::optional<PushRecord>& by) {
  const std::string who = stale.robot.empty() ? "the team" : stale.robot;
  auto refusal = conflict("It is to replace " + short_hash(replaces) + ", but " + who + " runs " +
                          origin(stale.hash, by) + "; look at it before you replace it.");
  refusal.running_hash = stale.hash;
  refusal.pushed = by;
  refusal.running_pushed = by;
  return refusal;
}

Refusal broken(TargetCheck check) {
  return {.reason = Refusal::Reason::kBroken,
          .message = "The program has errors; nothing was pushed.",
          .check = std::move(check)};
}

Refusal too_late(const PushRecord& push) {
  const bool is_over = push.progress.state != PushState::kRunning;
  auto refusal = conflict(is_over ? "This push is over: it is " + to_text(push.progress.state) + "."
                                  : "Every robot has been sent " + program_words(push) +
                                        " already; push the program before it to go back.");
  refusal.pushed = push;
  return refusal;
}

RefusedPush kept_form(const Refusal& refusal, const PushRecord& push) {
  RefusedPush kept{.id = push.id,
                   .ordered_ns = push.pushed_ns,
                   .author = push.author,
                   .targets = push.targets,
                   .program = push.program,
                   .reason = {},
                   .message = refusal.message};
  for (const auto& [reason, word] : kReasons)
    if (reason == refusal.reason) kept.reason = word;
  return kept;
}

Refusal refused_before(const RefusedPush& kept) {
  auto refusal = conflict(kept.message);
  for (const auto& [reason, word] : kReasons)
    if (word == kept.reason) refusal.reason = reason;
  return refusal;
}

nlohmann::json to_json(const Refusal& refusal) {
  auto json = nlohmann::json::object();
  if (refusal.running_hash) json["running_hash"] = *refusal.running_hash;
  if (refusal.pushed) json["pushed"] = to_json(*refusal.pushed);
  if (refusal.running_pushed) json["running_pushed"] = to_json(*refusal.running_pushed);
  if (refusal.check) {
    json["robot"] = refusal.check->refused_by;
    json["diagnostics"] = refusal.check->result.diagnostics;
    json["taken"] = refusal.check->taken;
  }
  return json;
}

}  // namespace galilean::monitor
