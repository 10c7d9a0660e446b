// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/schemas/ros2msg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "core/visible_text.h"

namespace galilean::monitor {
namespace {

using wire::TypeKind;

struct PrimitiveWord {
  std::string_view word;
  TypeKind kind;
};
/// A char is a number in ROS 2.
constexpr std::array<PrimitiveWord, 13> kPrimitiveWords{{{"bool", TypeKind::kBoolean},
                                                         {"byte", TypeKind::kByte},
                                                         {"char", TypeKind::kByte},
                                                         {"uint8", TypeKind::kByte},
                                                         {"int8", TypeKind::kInt8},
                                                         {"int16", TypeKind::kInt16},
                                                         {"uint16", TypeKind::kUint16},
                                                         {"int32", TypeKind::kInt32},
                                                         {"uint32", TypeKind::kUint32},
                                                         {"int64", TypeKind::kInt64},
                                                         {"uint64", TypeKind::kUint64},
                                                         {"float32", TypeKind::kFloat},
                                                         {"float64", TypeKind::kDouble}}};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Returns the part up to a blank, and goes on behind it.
std::string_view take_word(std::string_view& rest) {
  rest = trimmed(rest);
  const auto end = std::min(rest.find_first_of(" \t"), rest.size());
  const auto word = rest.substr(0, end);
  rest = trimmed(rest.substr(end));
  return word;
}

std::optional<std::uint32_t> number_of(std::string_view text) {
  std::uint32_t number = 0;
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (wrong != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return number;
}

/// Returns the package of "geometry_msgs::msg::Pose" with its room: "geometry_msgs::msg".
std::string scope_of(const std::string& name) {
  const auto last = name.rfind("::");
  return last == std::string::npos ? "" : name.substr(0, last);
}

/// Reads a type without what stands in brackets. Returns nothing if it is none.
std::optional<WrittenType> single_type(std::string_view word) {
  WrittenType type;
  for (const auto& primitive : kPrimitiveWords)
    if (primitive.word == word) {
      type.kind = WrittenType::Kind::kPrimitive;
      type.primitive = primitive.kind;
      return type;
    }
  if (word == "string" || word.starts_with("string<=")) {
    type.kind = WrittenType::Kind::kString;
    if (word.size() > 6) type.bound = number_of(word.substr(8));
    return word.size() > 6 && !type.bound ? std::nullopt : std::optional(type);
  }
  if (word.empty() || word.find_first_of("<>=[]:") != word.npos) return std::nullopt;
  type.name = word == "Header"                           ? "std_msgs::msg::Header"
              : word.find('/') == std::string_view::npos ? std::string(word)
                                                         : scoped_name(word);
  return type;
}

/// Reads the type of a field into `field`. Returns false if it is none.
bool read_type(std::string_view word, WrittenField& field) {
  const auto bracket = word.find('[');
  auto type = single_type(word.substr(0, bracket));
  if (!type) return false;
  if (bracket == word.npos) return field.type = *type, true;
  if (!word.ends_with(']')) return false;
  auto size = word.substr(bracket + 1, word.size() - bracket - 2);
  const bool bounded = size.starts_with("<=");
  if (bounded) size.remove_prefix(2);
  const auto number = number_of(size);
  if (!number && (bounded || !size.empty())) return false;
  if (number && !bounded) return field.type = *type, field.sizes = {*number}, true;
  field.type.kind = WrittenType::Kind::kSequence;
  field.type.bound = number;
  field.type.element = std::make_shared<WrittenType>(*type);
  return true;
}

bool is_separator(std::string_view line) {
  return line.size() >= 3 && line.find_first_not_of('=') == line.npos;
}

class Ros2MsgReader {
 public:
  explicit Ros2MsgReader(const std::string& type) : name_(scoped_name(type)) { begin(); }

  Result<Definitions> read(std::string_view text) {
    while (!text.empty()) {
      const auto end = std::min(text.find('\n'), text.size());
      const auto whole = text.substr(0, end);
      const auto line = trimmed(whole.substr(0, whole.find('#')));
      if (!take(line)) return Error{"has the line '" + visible(line) + "', which defines no field"};
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    return std::move(definitions_);
  }

 private:
  void begin() { definitions_[name_].scope = scope_of(name_); }

  bool take(std::string_view line) {
    if (line.empty()) return true;
    if (is_separator(line)) return separated_ = true;
    if (std::exchange(separated_, false)) {
      if (!line.starts_with("MSG:")) return false;
      name_ = scoped_name(trimmed(line.substr(4)));
      begin();
      return true;
    }
    return take_field(line);
  }

  bool take_field(std::string_view line) {
    const auto type = take_word(line);
    if (line.empty()) return false;
    const auto name = take_word(line);
    // A constant has no place in a message, and a default value changes none.
    if (name.find('=') != name.npos || line.starts_with('=')) return true;
    WrittenField field;
    field.name = name;
    if (!read_type(type, field)) return false;
    definitions_[name_].fields.push_back(std::move(field));
    return true;
  }

  std::string name_;
  bool separated_ = false;
  Definitions definitions_;
};

}  // namespace

std::string scoped_name(std::string_view ros_type) {
  const auto first = ros_type.find('/');
  if (first == ros_type.npos) return std::string(ros_type);
  const auto last = ros_type.rfind('/');
  const auto room =
      first == last ? "msg" : std::string(ros_type.substr(first + 1, last - first - 1));
  return std::string(ros_type.substr(0, first)) + "::" + room +
         "::" + std::string(ros_type.substr(last + 1));
}

Result<Definitions> parse_ros2msg(const std::string& type, std::string_view text) {
  return Ros2MsgReader(type).read(text);
}

}  // namespace galilean::monitor
