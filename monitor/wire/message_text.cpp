// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/message_text.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "core/json_text.h"
#include "core/spelling.h"
#include "core/visible_text.h"

namespace galilean::monitor {
namespace {

constexpr std::size_t kMostScalars = 32;  // of a list that are printed

Error no_such_field(const MessageTree& message, std::string_view name) {
  std::vector<std::string> owned;
  for (const auto& [key, value] : message.items()) owned.push_back(key);
  const std::vector<std::string_view> names(owned.begin(), owned.end());
  const std::string meant = meant_name(name, names);
  std::string sentence = "the message has no field '" + visible(name) + "'";
  if (!meant.empty()) return Error{sentence + "; did you mean '" + meant + "'?"};
  std::string list;
  for (const auto& known : owned) list += (list.empty() ? "" : ", ") + known;
  return Error{sentence + (list.empty() ? "" : "; it has " + list)};
}

bool is_scalar(const MessageTree& value) {
  return !value.is_structured();
}

std::string scalar_text(const MessageTree& value) {
  if (!value.is_string()) return ordered_json_text(value);
  const auto& text = value.get_ref<const std::string&>();
  return '"' + visible(text) + '"';
}

bool is_scalar_list(const MessageTree& value) {
  return value.is_array() && std::ranges::all_of(value, is_scalar);
}

std::string scalar_list(const MessageTree& list) {
  std::string text = "[";
  for (std::size_t i = 0; i < list.size() && i < kMostScalars; ++i)
    text += (i ? ", " : "") + scalar_text(list[i]);
  if (list.size() > kMostScalars)
    text += ", … " + std::to_string(list.size() - kMostScalars) + " more";
  return text + "]";
}

void append(std::string& text, const MessageTree& value, const std::string& indent);

/// Appends what stands behind "name:" or "-".
void append_value(std::string& text, const MessageTree& value, const std::string& indent) {
  if (is_scalar(value)) {
    text += ' ' + scalar_text(value) + '\n';
  } else if (is_scalar_list(value)) {
    text += ' ' + scalar_list(value) + '\n';
  } else {
    text += '\n';
    append(text, value, indent + "  ");
  }
}

void append_item(std::string& text, const MessageTree& item, const std::string& indent) {
  if (is_scalar(item) || is_scalar_list(item)) {
    text += indent + '-';
    return append_value(text, item, indent);
  }
  std::string block;
  append(block, item, indent + "  ");
  if (!block.empty()) block[indent.size()] = '-';
  text += block;
}

void append(std::string& text, const MessageTree& value, const std::string& indent) {
  if (value.is_object())
    for (const auto& [name, field] : value.items()) {
      text += indent + visible(name) + ':';
      append_value(text, field, indent);
    }
  else
    for (const auto& item : value) append_item(text, item, indent);
}

}  // namespace

Result<const MessageTree*> find_field(const MessageTree& message, std::string_view path) {
  const MessageTree* at = &message;
  while (!path.empty()) {
    if (path.front() == '.') path.remove_prefix(1);
    if (path.starts_with('[')) {
      std::size_t index = 0;
      const auto end = path.find(']');
      const auto number = path.substr(1, end == path.npos ? path.npos : end - 1);
      const auto read = std::from_chars(number.data(), number.data() + number.size(), index);
      if (end == path.npos || read.ec != std::errc() || read.ptr != number.data() + number.size())
        return Error{"'" + visible(path) + "' is not an index such as [0]"};
      if (!at->is_array()) return Error{"'" + visible(path) + "' stands behind what is no list"};
      if (index >= at->size()) return static_cast<const MessageTree*>(nullptr);
      at = &(*at)[index];
      path.remove_prefix(end + 1);
      continue;
    }
    const auto name = path.substr(0, path.find_first_of(".["));
    if (!at->is_object() || !at->contains(name)) return no_such_field(*at, name);
    at = &(*at)[std::string(name)];
    path.remove_prefix(name.size());
  }
  return at;
}

std::string readable_text(const MessageTree& message) {
  if (is_scalar(message)) return scalar_text(message) + '\n';
  if (is_scalar_list(message)) return scalar_list(message) + '\n';
  std::string text;
  append(text, message, "");
  return text;
}

}  // namespace galilean::monitor
