// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/message_decoder.h"

#include <array>
#include <charconv>
#include <map>
#include <sstream>
#include <string>

#include "core/wire/cdr.h"
#include "core/wire/generate/idl.h"

namespace galilean::monitor {
namespace {

template <class T>
MessageTree read_value(msg::CdrReader& reader) {
  T value{};
  reader.read(value);
  return value;
}

/// Reads a float as the shortest decimal that names it: 0.1 instead of 0.10000000149011612.
template <>
MessageTree read_value<float>(msg::CdrReader& reader) {
  float value = 0;
  reader.read(value);
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  double shortest = value;
  std::from_chars(digits.data(), end, shortest);
  return shortest;
}

using ReadBasic = MessageTree (*)(msg::CdrReader&);
const std::map<std::string_view, ReadBasic> kReadBasic{
    {"boolean", read_value<bool>},
    {"octet", read_value<std::uint8_t>},
    {"uint8", read_value<std::uint8_t>},
    {"int8", read_value<std::int8_t>},
    {"short", read_value<std::int16_t>},
    {"unsigned short", read_value<std::uint16_t>},
    {"long", read_value<std::int32_t>},
    {"unsigned long", read_value<std::uint32_t>},
    {"long long", read_value<std::int64_t>},
    {"unsigned long long", read_value<std::uint64_t>},
    {"float", read_value<float>},
    {"double", read_value<double>},
    {"string", read_value<std::string>}};

/// Returns the definition without the lines that separate its parts.
std::string plain_idl(std::string_view text) {
  std::istringstream lines{std::string(text)};
  std::string plain;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("====") && !line.starts_with("IDL:")) plain += line + '\n';
  return plain;
}

std::string idl_name(std::string_view ros_type) {
  std::string name;
  for (const char letter : ros_type)
    name += letter == '/' ? std::string("::") : std::string(1, letter);
  return name;
}

}  // namespace

struct MessageDecoder::Definitions {
  std::string top;
  std::map<std::string, idl::Struct> structs;

  MessageTree read(msg::CdrReader& reader, const std::string& type) const {
    if (const auto basic = kReadBasic.find(type); basic != kReadBasic.end())
      return basic->second(reader);
    auto tree = MessageTree::object();
    for (const auto& field : structs.at(type).fields) tree[field.name] = read(reader, field);
    return tree;
  }
  MessageTree read(msg::CdrReader& reader, const idl::Field& field) const {
    auto count = static_cast<std::uint32_t>(field.array_size);
    if (field.sequence) reader.read(count);
    if (!field.sequence && count == 0) return read(reader, field.type);
    auto items = MessageTree::array();
    for (std::uint32_t i = 0; i < count && reader.ok(); ++i)
      items.push_back(read(reader, field.type));
    return items;
  }
};

MessageDecoder::MessageDecoder(const wire::Schema& schema)
    : definitions_(std::make_unique<Definitions>()) {
  definitions_->top = idl_name(schema.ros_type);
  const auto file = idl::parse(std::string(schema.ros_type), plain_idl(schema.idl));
  for (const auto& type : file.structs)
    definitions_->structs.emplace(type.module + "::" + type.name, type);
}

MessageDecoder::~MessageDecoder() = default;
MessageDecoder::MessageDecoder(MessageDecoder&&) noexcept = default;

Result<MessageTree> MessageDecoder::decode(std::span<const std::uint8_t> cdr) const {
  msg::CdrReader reader(cdr);
  auto tree = definitions_->read(reader, definitions_->top);
  if (!reader.ok()) return Error{"a message is not a whole " + definitions_->top};
  return tree;
}

}  // namespace galilean::monitor
