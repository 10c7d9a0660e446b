// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/completion.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "bhdl/check/describe.h"
#include "bhdl/check/expectation_specs.h"
#include "bhdl/check/state_specs.h"
#include "bhdl/lsp/documents/cursor.h"
#include "bhdl/lsp/features/completion_list.h"
#include "bhdl/lsp/features/snippet.h"
#include "bhdl/source/text.h"
#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl::lsp {
namespace {

bool takes_several(const AttributeSpec& spec) {
  return spec.type == AttributeType::kNames || spec.type == AttributeType::kNumbers;
}

bool takes_number(const AttributeSpec& spec) {
  return spec.type == AttributeType::kNumber || spec.type == AttributeType::kInteger ||
         spec.type == AttributeType::kNumbers || spec.type == AttributeType::kPair;
}

/// The part of the text that a proposal replaces: the word around the cursor.
struct Replaced {
  ByteRange range;
  bool closed = false;    ///< a quote stands behind it
  bool labelled = false;  ///< a colon stands behind it
};

Replaced replaced_by(const ParsedFile& file, const Cursor& cursor, std::size_t offset) {
  const std::string_view text = file.text;
  std::size_t end = offset;
  while (end < text.size() &&
         (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_'))
    ++end;
  const auto rest = text.substr(end);
  const bool closed = cursor.in_text && (rest.starts_with('"') || rest.starts_with("”"));
  if (cursor.in_text && !closed) end = offset;
  return {{cursor.word.begin, end}, closed, !cursor.in_text && rest.starts_with(':')};
}

class Completer {
 public:
  Completer(const Session& session, const ParsedFile& file, const Cursor& cursor,
            const Replaced& replaced)
      : session_(session),
        file_(file),
        cursor_(cursor),
        replaced_(replaced),
        list_(session, session.range(file, replaced.range)) {}

  Json run() {
    if (cursor_.in_comment) return std::move(list_).result();
    const AttributeSpec* spec = attribute_at_hand();
    const bool value_due = !cursor_.attribute.empty() &&
                           (cursor_.values.empty() || cursor_.behind == TokenKind::kComma);
    if (cursor_.behind == TokenKind::kNumber) units(spec);
    if (!cursor_.attribute.empty() && (value_due || cursor_.in_text || goes_on(spec))) values(spec);
    if (on_swap_target()) names(NameSpace::kState, {}, ItemKind::kEvent);
    if (!value_due && !cursor_.in_text) labels();
    return std::move(list_).result();
  }

 private:
  [[nodiscard]] const ComponentSpec* component_at_hand() const {
    const Block* block = cursor_.innermost();
    if (block == nullptr) return nullptr;
    if (block->kind == BlockKind::kCondition) return &condition_spec();
    const bool state = block->kind == BlockKind::kState || block->kind == BlockKind::kSchemaList;
    return state ? &state_spec() : spec_of(*block, session_.vocabulary);
  }
  [[nodiscard]] const AttributeSpec* attribute_at_hand() const {
    const ComponentSpec* component = component_at_hand();
    return component == nullptr ? nullptr : component->find(cursor_.attribute);
  }
  [[nodiscard]] static bool goes_on(const AttributeSpec* spec) {
    return spec != nullptr && takes_several(*spec);
  }
  [[nodiscard]] bool on_swap_target() const {
    const Block* block = cursor_.innermost();
    return block != nullptr && block->kind == BlockKind::kOnSwap &&
           cursor_.behind == TokenKind::kColon && !cursor_.values.empty();
  }

  void units(const AttributeSpec* spec) {
    for (const auto& unit : all_units()) {
      const bool fits = spec == nullptr || unit.dimension == spec->unit.dimension;
      if (!unit.symbol.empty() && fits)
        list_.add({std::string(unit.symbol), ItemKind::kUnit, std::string(unit.dimension)});
    }
  }

  void values(const AttributeSpec* spec) {
    if (cursor_.attribute == "extends") return bases();
    if (cursor_.innermost() == nullptr) return top_level_values();
    if (spec == nullptr) return constants();
    if (!spec->refers_to.empty()) {
      const bool any = spec->refers_to == "variable";
      const NameSpace space = referred_space(spec->refers_to);
      names(space, space == NameSpace::kVariable && !any ? spec->refers_to : "", kind_of(space));
    }
    for (const auto& choice : spec->choices) text(choice, ItemKind::kEnumMember, spec->help);
    if (spec->type == AttributeType::kFlag && !cursor_.in_text)
      for (const char* word : {"yes", "no"}) list_.add({word, ItemKind::kValue, spec->help});
    if (takes_number(*spec) || takes_several(*spec)) constants();
  }

  void top_level_values() {
    if (cursor_.attribute == "start_state") names(NameSpace::kState, {}, ItemKind::kEvent);
    if (cursor_.attribute != "include") return;
    const auto folder = std::filesystem::path(file_.path).parent_path();
    for (const auto& path : session_.workspace.beside(file_.path))
      if (path != file_.path)
        text(std::filesystem::path(path).lexically_relative(folder).generic_string(),
             ItemKind::kFile, {});
  }

  void bases() {
    const Block* block = cursor_.innermost();
    if (block == nullptr) return;
    if (block->kind == BlockKind::kState) return names(NameSpace::kState, {}, ItemKind::kEvent);
    const NameSpace space = name_space(block->components);
    names(space, std::string(block->word), kind_of(space));
  }

  [[nodiscard]] static ItemKind kind_of(NameSpace space) {
    if (space == NameSpace::kVariable) return ItemKind::kVariable;
    return space == NameSpace::kState ? ItemKind::kEvent : ItemKind::kClass;
  }

  /// Proposes names that the program gives, of one type unless `type` is empty. Names that are
  /// listed already, and the block's own name, are left out.
  void names(NameSpace space, const std::string& type, ItemKind kind) {
    std::set<std::string_view> left_out(cursor_.values.begin(), cursor_.values.end());
    if (cursor_.attribute == "extends") left_out.insert(cursor_.innermost()->name);
    const auto programs = session_.workspace.programs_with(file_.path);
    for (const auto& program : programs)
      for (const auto& file : program)
        for (const auto& mention : file->mentions().names)
          if (mention.declares && mention.space == space &&
              (type.empty() || mention.type == type) && left_out.insert(mention.name).second)
            text(std::string(mention.name), kind, std::string(mention.type));
  }

  void constants() {
    if (cursor_.in_text) return;
    std::set<std::string_view> seen{cursor_.attribute};
    const auto programs = session_.workspace.programs_with(file_.path);
    for (const auto& program : programs)
      for (const auto& file : program)
        for (const auto& mention : file->mentions().names)
          if (mention.declares && mention.space == NameSpace::kConstant &&
              seen.insert(mention.name).second)
            list_.add({std::string(mention.name), ItemKind::kConstant, "constant"});
  }

  void text(const std::string& content, ItemKind kind, const std::string& detail) {
    const std::string open = cursor_.in_text ? "" : "\"";
    const std::string close = replaced_.closed ? "" : "\"";
    list_.add({content, kind, detail, {}, open + content + close});
  }

  void labels() {
    const Block* block = cursor_.innermost();
    if (block == nullptr) return sections();
    switch (block->kind) {
      case BlockKind::kSection:
        components(block->components);
        break;
      case BlockKind::kStates:
        component(state_spec(), false);
        break;
      case BlockKind::kComponent:
      case BlockKind::kState:
      case BlockKind::kCondition:
      case BlockKind::kExpect:
      case BlockKind::kExpectStep:
        attributes(*block);
        break;
      default:
        break;
    }
    list_.add({"end", ItemKind::kKeyword, "closes " + std::string(block->word)});
    if (block->kind == BlockKind::kSection || block->kind == BlockKind::kStates) sections();
  }

  void sections() {
    for (const auto word : section_words()) {
      const std::string label(word);
      list_.add({label, ItemKind::kModule, "section", {}, label + (replaced_.labelled ? "" : ":")});
    }
    if (cursor_.innermost() == nullptr) component(state_spec(), false);
  }

  void components(ComponentKind kind) {
    for (const auto& spec : session_.vocabulary.components())
      if (spec.kind == kind) component(spec, kind == ComponentKind::kVariable);
  }

  void component(const ComponentSpec& spec, bool is_variable) {
    const bool labelled = replaced_.labelled;
    list_.add({spec.name,
               ItemKind::kClass,
               {},
               spec.help,
               spec.name + (labelled ? "" : ":"),
               labelled ? std::string() : component_snippet(spec, is_variable)});
  }

  void attributes(const Block& block) {
    const ComponentSpec* spec = component_at_hand();
    if (spec == nullptr) return;
    for (const auto& each : spec->attributes)
      if (!cursor_.given.contains(each.name)) attribute(each);
    const bool extends = block.kind == BlockKind::kState ||
                         (block.kind == BlockKind::kComponent && !is_device(spec->kind));
    if (extends && !cursor_.given.contains("extends"))
      attribute({.name = "extends",
                 .type = AttributeType::kName,
                 .refers_to = spec->name,
                 .help = "copies all attributes of another one except its name"});
    if (block.kind == BlockKind::kState) component(condition_spec(), false);
    if (block.kind == BlockKind::kExpect)
      for (const auto& step : step_specs()) component(step, false);
    if (block.kind == BlockKind::kComponent && block.components == ComponentKind::kVariable &&
        cursor_.given.contains("name"))
      components(ComponentKind::kVariable);
  }

  void attribute(const AttributeSpec& spec) {
    int next = 1;
    const bool labelled = replaced_.labelled;
    list_.add({spec.name, ItemKind::kField, facts_in_words(spec), spec.help,
               spec.name + (labelled ? "" : ": "),
               labelled ? std::string() : spec.name + ": " + value_snippet(spec, next)});
  }

  const Session& session_;
  const ParsedFile& file_;
  const Cursor& cursor_;
  const Replaced& replaced_;
  CompletionList list_;
};

}  // namespace

Json completion(const Session& session, const Json& params) {
  const FilePointer file = session.file(params);
  const std::size_t offset = session.offset(*file, params);
  if (!file->is_readable) return nullptr;
  const Cursor cursor = cursor_at(file->parse_tree, offset, session.vocabulary);
  const Replaced replaced = replaced_by(*file, cursor, offset);
  return Completer(session, *file, cursor, replaced).run();
}

}  // namespace galilean::bhdl::lsp
