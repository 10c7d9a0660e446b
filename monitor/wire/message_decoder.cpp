// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/message_decoder.h"

#include <optional>
#include <string>

#include "core/visible_text.h"
#include "core/wire/types/member_header.h"
#include "monitor/wire/scalar_tree.h"

namespace galilean::monitor {
namespace {

using wire::CdrCursor;
using wire::Extensibility;
using wire::TypeDescription;
using wire::TypeKind;
using wire::TypeMember;

/// One message on its way to a tree.
class Decoding {
 public:
  explicit Decoding(CdrCursor& cursor) : cursor_(cursor), most_values_(cursor.left() + kSpare) {}

  MessageTree value(const TypeDescription& type) {
    if (!count_value()) return {};
    switch (type.kind) {
      case TypeKind::kSequence:
        return sequence(type);
      case TypeKind::kArray:
        return array(type);
      case TypeKind::kStruct:
        return type.extensibility == Extensibility::kMutable ? mutable_structure(type)
                                                             : structure(type);
      case TypeKind::kUnion:
        return choice(type);
      default:
        return read_scalar(type, cursor_);
    }
  }

 private:
  /// Values that take no bytes, such as empty structs, could be without number.
  static constexpr std::size_t kSpare = 100'000;

  bool count_value() {
    if (++values_ > most_values_) cursor_.fail();
    return cursor_.ok();
  }

  /// Enters what begins with its size, if version 2 writes the size there.
  std::optional<CdrCursor::Whole> enter_sized(bool sized) {
    if (!sized || !cursor_.is_second()) return std::nullopt;
    return cursor_.enter(cursor_.read<std::uint32_t>());
  }
  void leave(const std::optional<CdrCursor::Whole>& whole) {
    if (whole) cursor_.leave(*whole);
  }

  MessageTree letters(std::size_t count) {
    const auto bytes = cursor_.read_bytes(count);
    std::string text(bytes.begin(), bytes.end());
    text.erase(text.find_last_not_of('\0') + 1);
    return text;
  }

  MessageTree items(const TypeDescription& element, std::size_t count) {
    if (element.kind == TypeKind::kChar) return letters(count);
    auto list = MessageTree::array();
    for (; count > 0 && cursor_.ok(); --count) list.push_back(value(element));
    return list;
  }

  MessageTree sequence(const TypeDescription& type) {
    const auto whole = enter_sized(!wire::is_primitive(type.element->kind));
    auto list = items(*type.element, cursor_.read<std::uint32_t>());
    leave(whole);
    return list;
  }

  MessageTree array(const TypeDescription& type) {
    const auto whole = enter_sized(!wire::is_primitive(type.element->kind));
    auto list = dimension(type, 0);
    leave(whole);
    return list;
  }
  MessageTree dimension(const TypeDescription& type, std::size_t index) {
    if (index + 1 == type.bounds.size()) return items(*type.element, type.bounds[index]);
    auto list = MessageTree::array();
    for (std::size_t i = 0; i < type.bounds[index] && count_value(); ++i)
      list.push_back(dimension(type, index + 1));
    return list;
  }

  MessageTree structure(const TypeDescription& type) {
    const bool sized = type.extensibility == Extensibility::kAppendable;
    const auto whole = enter_sized(sized);
    auto tree = MessageTree::object();
    for (const auto& member : type.members) {
      const bool left_out = whole && cursor_.left() == 0;
      tree[member.name] = left_out ? MessageTree() : member_value(member);
    }
    leave(whole);
    return tree;
  }

  MessageTree member_value(const TypeMember& member) {
    if (!member.optional) return value(*member.type);
    if (cursor_.is_second())
      return cursor_.read<std::uint8_t>() ? value(*member.type) : MessageTree();
    const auto header = wire::optional_header(cursor_);
    return header.size > 0 ? sized_value(member, header.size) : MessageTree();
  }
  /// Reads a member behind a header that told its size. In version 1 it is aligned by itself.
  MessageTree sized_value(const TypeMember& member, std::size_t size) {
    const auto whole = cursor_.enter(size, !cursor_.is_second());
    auto tree = value(*member.type);
    cursor_.leave(whole);
    return tree;
  }

  MessageTree mutable_structure(const TypeDescription& type) {
    const auto whole = enter_sized(true);
    auto tree = MessageTree::object();
    for (const auto& member : type.members) tree[member.name] = nullptr;
    while (const auto header = wire::next_member(cursor_)) {
      const auto* member = member_of(type, header->id);
      if (member)
        tree[member->name] = sized_value(*member, header->size);
      else
        cursor_.read_bytes(header->size);
    }
    leave(whole);
    return tree;
  }
  static const TypeMember* member_of(const TypeDescription& type, std::uint32_t id) {
    for (const auto& member : type.members)
      if (member.id == id) return &member;
    return nullptr;
  }

  MessageTree choice(const TypeDescription& type) {
    const auto whole = enter_sized(type.extensibility == Extensibility::kAppendable);
    const auto bits = read_bits(*type.element, cursor_);
    auto tree = MessageTree::object();
    tree["discriminator"] = tree_of_bits(*type.element, bits);
    if (const auto* member = selected(type, bits)) tree[member->name] = value(*member->type);
    leave(whole);
    return tree;
  }
  static const TypeMember* selected(const TypeDescription& type, std::uint64_t bits) {
    const TypeMember* otherwise = nullptr;
    for (const auto& member : type.members) {
      for (const auto label : member.labels)
        if (is_label(*type.element, bits, label)) return &member;
      if (member.otherwise) otherwise = &member;
    }
    return otherwise;
  }

  CdrCursor& cursor_;
  std::size_t values_ = 0;
  const std::size_t most_values_;
};

}  // namespace

Result<MessageTree> MessageDecoder::decode(std::span<const std::uint8_t> cdr) const {
  CdrCursor cursor(cdr);
  auto tree = Decoding(cursor).value(*type_);
  if (!cursor.ok()) return Error{"a message is not a whole " + visible(type_->name)};
  return tree;
}

}  // namespace galilean::monitor
