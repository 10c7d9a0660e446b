// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/control/recorder_status.h"

#include <charconv>
#include <utility>

#include "core/plural.h"
#include "core/wire/ros_time.h"
#include "monitor/record/times.h"

namespace galilean::monitor {
namespace {

constexpr std::uint8_t kGood = 0, kWarning = 1;

std::string state_text(const RecorderStatus& status) {
  if (status.paused_since_ns)
    return "paused since " + iso_time(static_cast<std::uint64_t>(*status.paused_since_ns));
  if (status.missing > 0)
    return "records; " + plural(status.missing, "message") +
           agreeing(status.missing, " is missing", " are missing");
  return "records";
}

template <class Number>
std::optional<Number> number_in(const std::string& text) {
  Number number = 0;
  const auto* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return number;
}

}  // namespace

msg::DiagnosticArray to_message(const RecorderStatus& status, std::int64_t now_ns) {
  msg::DiagnosticArray message;
  message.header.stamp = wire::ros_time(now_ns);
  auto& told = message.status.emplace_back();
  told.level = status.paused_since_ns || status.missing > 0 ? kWarning : kGood;
  told.name = "recorder " + status.name;
  told.message = state_text(status);
  told.hardware_id = status.host;
  const auto add = [&](std::string key, std::string value) {
    auto& each = told.values.emplace_back();
    each.key = std::move(key);
    each.value = std::move(value);
  };
  add("recorder", status.name);
  add("file", status.file);
  add("paused_since_ns", status.paused_since_ns ? std::to_string(*status.paused_since_ns) : "");
  add("messages", std::to_string(status.messages));
  add("missing", std::to_string(status.missing));
  add("obeyed", status.obeyed);
  return message;
}

std::optional<RecorderStatus> read_status(const msg::DiagnosticArray& message) {
  if (message.status.size() != 1) return std::nullopt;
  const auto& told = message.status.front();
  RecorderStatus status;
  status.host = told.hardware_id;
  bool is_recorder = false;
  for (const auto& [key, value] : told.values) {
    if (key == "recorder") {
      is_recorder = true;
      status.name = value;
    }
    if (key == "file") status.file = value;
    if (key == "paused_since_ns") status.paused_since_ns = number_in<std::int64_t>(value);
    if (key == "messages") status.messages = number_in<std::uint64_t>(value).value_or(0);
    if (key == "missing") status.missing = number_in<std::uint64_t>(value).value_or(0);
    if (key == "obeyed") status.obeyed = value;
  }
  return is_recorder ? std::optional(status) : std::nullopt;
}

}  // namespace galilean::monitor
