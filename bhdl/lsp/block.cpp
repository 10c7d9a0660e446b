#include "bhdl/lsp/block.h"

#include <algorithm>

#include "bhdl/check/expectation_specs.h"
#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl::lsp {
namespace {

BlockKind kind_of_section(std::string_view word) {
  if (section_kind(word)) return BlockKind::kSection;
  if (word == "states") return BlockKind::kStates;
  if (word == "state") return BlockKind::kState;
  if (word == "expect") return BlockKind::kExpect;
  return word == "define" ? BlockKind::kDefine : BlockKind::kOnSwap;
}

const ComponentSpec* find_step(std::string_view word) {
  const auto steps = step_specs();
  const auto found = std::ranges::find(steps, word, &ComponentSpec::name);
  return found == steps.end() ? nullptr : &*found;
}

bool opens_no_block(std::string_view word) {
  return word == "include" || word == "start_state";
}

}  // namespace

const ComponentSpec* spec_of(const Block& block, const Vocabulary& vocabulary) {
  if (block.kind == BlockKind::kComponent) return vocabulary.find(block.word);
  if (block.kind == BlockKind::kExpectStep) return find_step(block.word);
  return block.kind == BlockKind::kExpect ? &expect_spec() : nullptr;
}

void BlockScanner::run() {
  while (!tokens_.at_end_of_file()) step();
}

std::vector<Block> blocks_of(std::string_view text, const Vocabulary& vocabulary) {
  BlockScanner scanner(text, vocabulary);
  scanner.run();
  scanner.close_all();
  return scanner.blocks();
}

void BlockScanner::step() {
  const bool in_state = inside(BlockKind::kState);
  if (tokens_.at_word("end")) return take_end_word();
  if (in_state && at_schema_list(tokens_)) {
    close_down_to(depth_behind(BlockKind::kState));
    begin_attribute();
    return open_block(BlockKind::kSchemaList);
  }
  if (in_state && tokens_.at_label("condition")) {
    close_down_to(depth_behind(BlockKind::kState));
    return open_block(BlockKind::kCondition);
  }
  if (begins_section()) return open_section();
  if (inside(BlockKind::kExpect) && tokens_.at_label() && find_step(tokens_.peek().text)) {
    close_down_to(depth_behind(BlockKind::kExpect));
    return open_block(BlockKind::kExpectStep);
  }
  if (tokens_.at_label()) return label();
  value();
}

// `variables:` at the cursor may be what the component at hand calls an attribute.
bool BlockScanner::begins_section() const noexcept {
  if (!at_section(tokens_)) return false;
  const bool nothing_behind = tokens_.peek(2).kind == TokenKind::kEndOfFile;
  return !(nothing_behind && is_attribute_of_innermost());
}

void BlockScanner::open_section() {
  const std::string_view word = tokens_.peek().text;
  close_down_to(word == "state" ? depth_behind(BlockKind::kStates) : 0);
  if (!opens_no_block(word)) return open_block(kind_of_section(word));
  begin_attribute();
  take();
  if (tokens_.at(TokenKind::kColon)) take();
}

void BlockScanner::label() {
  const Block* block = innermost();
  if (block == nullptr || block->kind == BlockKind::kStates || block->kind == BlockKind::kOnSwap) {
    take();
    take();
    return;
  }
  if (block->kind == BlockKind::kSection) return open_block(BlockKind::kComponent);
  if (block->kind == BlockKind::kComponent) return component_label();
  if (block->kind == BlockKind::kSchemaList) close_last();
  begin_attribute();
  take();
  take();
}

void BlockScanner::component_label() {
  const bool known = is_attribute_of_innermost();
  const bool bare = tokens_.at_bare_label();
  const bool before_name = tokens_.at_label_before_label() && tokens_.peek(2).text == "name";
  const bool variable = innermost()->components == ComponentKind::kVariable;
  const bool other_component =
      !known && (variable || vocabulary_.find(tokens_.peek().text) != nullptr);
  if (before_name || (bare && other_component)) {
    close_last();
    return open_block(BlockKind::kComponent);
  }
  begin_attribute();
  take();
  take();
}

bool BlockScanner::is_attribute_of_innermost() const noexcept {
  const Block* block = innermost();
  const ComponentSpec* spec = block == nullptr ? nullptr : spec_of(*block, vocabulary_);
  return spec != nullptr && spec->find(tokens_.peek().text) != nullptr;
}

void BlockScanner::value() {
  const bool unit = last_.kind == TokenKind::kNumber && tokens_.at(TokenKind::kWord);
  const Token token = take();
  const bool is_value = token.kind == TokenKind::kText || token.kind == TokenKind::kNumber ||
                        (token.kind == TokenKind::kWord && !unit);
  if (!is_value) return;
  values_.push_back(token.text);
  const bool names = attribute_ == "name" && token.kind == TokenKind::kText;
  if (names && !open_.empty()) blocks_[open_.back().block].name = token.text;
}

void BlockScanner::begin_attribute() {
  attribute_ = tokens_.peek().text;
  values_.clear();
  if (!open_.empty()) open_.back().given.push_back(attribute_);
}

// The stream stands at the block's label.
void BlockScanner::open_block(BlockKind kind) {
  Block block;
  block.kind = kind;
  block.word = tokens_.peek().text;
  block.range = {offset_of(tokens_.peek()), 0};
  if (!open_.empty()) {
    block.parent = open_.back().block;
    block.components = innermost()->components;
  }
  if (const auto components = section_kind(block.word); kind == BlockKind::kSection)
    block.components = *components;
  if (kind != BlockKind::kSchemaList) attribute_ = {};
  values_.clear();
  open_.push_back({blocks_.size(), {}});
  blocks_.push_back(block);
  take();
  if (tokens_.at(TokenKind::kColon)) take();
}

void BlockScanner::take_end_word() {
  const std::size_t before = last_end_;
  take();
  if (tokens_.at(TokenKind::kColon)) take();
  if (open_.empty()) return;
  Block& block = blocks_[open_.back().block];
  close_last();
  // A variable needs no `end`: the last of a section stands before the section's.
  const bool variable =
      block.kind == BlockKind::kComponent && block.components == ComponentKind::kVariable;
  if (variable && (tokens_.at_end_of_file() || at_section(tokens_))) block.range.end = before;
}

void BlockScanner::close_last() {
  blocks_[open_.back().block].range.end = last_end_;
  open_.pop_back();
  attribute_ = {};
  values_.clear();
}

void BlockScanner::close_down_to(std::size_t depth) {
  while (open_.size() > depth) close_last();
}

std::size_t BlockScanner::depth_behind(BlockKind kind) const noexcept {
  for (std::size_t depth = open_.size(); depth > 0; --depth)
    if (blocks_[open_[depth - 1].block].kind == kind) return depth;
  return 0;
}

Token BlockScanner::take() {
  last_ = tokens_.take();
  if (last_.kind != TokenKind::kEndOfFile) last_end_ = offset_of(last_) + last_.text.size();
  return last_;
}

}  // namespace galilean::bhdl::lsp
