// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/mention.h"

#include "bhdl/check/attribute_context.h"
#include "bhdl/lsp/documents/entity.h"

namespace galilean::bhdl::lsp {
namespace {

class MentionFinder {
 public:
  explicit MentionFinder(const Vocabulary& vocabulary) : vocabulary_(vocabulary) {}

  void find(const SyntaxTree& tree) {
    for (const auto& node : tree) std::visit([this](const auto& each) { in(each); }, node);
  }
  [[nodiscard]] Mentions found() && { return std::move(found_); }

 private:
  template <class Node>
  void in(const Node& node) {
    for_each_entity(node, vocabulary_, [this](const Entity& entity) { in_entity(entity); });
  }
  void in(const DefineNode& node) {
    for (const auto& constant : node.constants) {
      found_.names.push_back({NameSpace::kConstant, constant.name.text, true, {}});
      for (const auto& value : constant.values) in_definition(constant, value);
    }
  }
  void in(const StartStateNode& node) { use(NameSpace::kState, node.state.text); }
  // The old state is left out, because it belongs to the program that is replaced.
  void in(const SwapNode& node) { use(NameSpace::kState, node.new_state.text); }

  void in_definition(const AttributeNode& constant, const ValueNode& value) {
    const bool is_text = value.kind == ValueNode::Kind::kText;
    if (!is_text && value.kind != ValueNode::Kind::kBareWord) return;
    found_.defined.push_back({constant.name.text, value.text, is_text});
    if (!is_text) use(NameSpace::kConstant, value.text);
  }

  void in_entity(const Entity& entity) {
    const ValueNode* own_name = entity.space ? given_name(entity.attributes) : nullptr;
    const bool typed = own_name != nullptr && *entity.space != NameSpace::kState;
    if (own_name != nullptr)
      found_.names.push_back(
          {*entity.space, own_name->text, true, typed ? entity.type.text : std::string_view()});
    for (const auto& attribute : entity.attributes) in_attribute(entity, attribute);
  }

  void in_attribute(const Entity& entity, const AttributeNode& attribute) {
    const auto space = space_of_names(entity, attribute.name.text);
    for (const auto& value : attribute.values) {
      if (value.kind == ValueNode::Kind::kBareWord)
        found_.names.push_back({NameSpace::kConstant, value.text, false, {}, space});
      else if (space && value.kind == ValueNode::Kind::kText)
        use(*space, value.text);
    }
  }

  [[nodiscard]] static std::optional<NameSpace> space_of_names(const Entity& entity,
                                                               std::string_view attribute) {
    if (attribute == "extends") return entity.space;
    const AttributeSpec* spec = entity.spec == nullptr ? nullptr : entity.spec->find(attribute);
    if (spec == nullptr || spec->refers_to.empty()) return std::nullopt;
    return referred_space(spec->refers_to);
  }

  void use(NameSpace space, std::string_view name) {
    found_.names.push_back({space, name, false, {}});
  }

  const Vocabulary& vocabulary_;
  Mentions found_;
};

}  // namespace

Mentions find_mentions(const SyntaxTree& tree, const Vocabulary& vocabulary) {
  MentionFinder finder(vocabulary);
  finder.find(tree);
  return std::move(finder).found();
}

}  // namespace galilean::bhdl::lsp
