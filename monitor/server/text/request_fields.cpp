// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/text/request_fields.h"

#include <utility>

#include "core/json_text.h"

namespace galilean::monitor {
namespace {

using nlohmann::json;

const char* kind_of(const json& value) {
  switch (value.type()) {
    case json::value_t::null:
      return "null";
    case json::value_t::object:
      return "an object";
    case json::value_t::array:
      return "an array";
    case json::value_t::string:
      return "a string";
    case json::value_t::boolean:
      return "a boolean";
    default:
      return "a number";
  }
}

bool is_whole_number(const json& value) {
  if (value.is_number_unsigned()) return std::in_range<int>(value.get<std::uint64_t>());
  return value.is_number_integer() && std::in_range<int>(value.get<std::int64_t>());
}

std::string must_be(const char* name, const std::string& what) {
  return "'" + std::string(name) + "' must be " + what + ".";
}

}  // namespace

RequestFields::RequestFields(const json& request) : request_(request) {
  if (!request.is_object())
    refuse(std::string("The body must be a JSON object; it is ") + kind_of(request) + ".");
}

const json* RequestFields::find(const char* name) const {
  const auto found = request_.find(name);
  return found == request_.end() ? nullptr : &*found;
}

void RequestFields::refuse(std::string why) {
  if (objection_.empty()) objection_ = std::move(why);
}

std::string RequestFields::text(const char* name, std::string absent) {
  const json* value = find(name);
  if (value && value->is_string()) return *value;
  if (value) refuse(must_be(name, "a string"));
  return absent;
}

int RequestFields::whole_number(const char* name, int absent, int least, int most) {
  const json* value = find(name);
  if (!value) return absent;
  // The type is asked first, because the conversion of a larger number would keep its lowest bits.
  if (is_whole_number(*value)) {
    const int number = *value;
    if (number >= least && number <= most) return number;
  }
  refuse(must_be(name,
                 "a whole number from " + std::to_string(least) + " to " + std::to_string(most)));
  return absent;
}

double RequestFields::number(const char* name, double absent, double least, double most) {
  const json* value = find(name);
  if (!value) return absent;
  const bool fits =
      value->is_number() && value->get<double>() >= least && value->get<double>() <= most;
  if (fits) return *value;
  refuse(must_be(name, "a number from " + json_text(json(least)) + " to " + json_text(json(most))));
  return absent;
}

bool RequestFields::flag(const char* name) {
  const json* value = find(name);
  if (value && value->is_boolean()) return *value;
  if (value) refuse(must_be(name, "true or false"));
  return false;
}

const json& RequestFields::list(const char* name) {
  static const json kNone = json::array();
  const json* value = find(name);
  if (value && value->is_array()) return *value;
  refuse(must_be(name, "a list"));
  return kNone;
}

std::vector<std::string> RequestFields::names(const char* name) {
  std::vector<std::string> names;
  const json* value = find(name);
  if (!value) return names;
  const auto wrong = must_be(name, "a list of strings");
  if (!value->is_array()) return refuse(wrong), names;
  for (const auto& item : *value) {
    if (!item.is_string()) return refuse(wrong), std::vector<std::string>();
    names.push_back(item);
  }
  return names;
}

}  // namespace galilean::monitor
