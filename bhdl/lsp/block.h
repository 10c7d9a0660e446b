#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bhdl/check/vocabulary.h"
#include "bhdl/lsp/text_index.h"
#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl::lsp {

enum class BlockKind {
  kSection,
  kStates,
  kComponent,
  kState,
  kSchemaList,
  kCondition,
  kDefine,
  kOnSwap,
  kExpect,
  kExpectStep
};

/// What an editor shows as one piece: from its label to its `end`, or to where something else must
/// have closed it.
struct Block {
  BlockKind kind = BlockKind::kSection;
  std::string_view word;       ///< of its label
  std::string_view name;       ///< a component's or a state's; empty: none is given
  ComponentKind components{};  ///< of a section, and of what stands in it
  ByteRange range;
  std::optional<std::size_t> parent;  ///< among all blocks, which stand in the order of the text
};

/// What the catalog, or the language, says of a component, an expectation or one of its steps;
/// nullptr of any other block and where nothing has such a name.
[[nodiscard]] const ComponentSpec* spec_of(const Block& block, const Vocabulary& vocabulary);

/// Finds the blocks of a text that need not parse: where the parser would have to know what was
/// meant, this takes the likely. Goes token by token, so that its state at a cursor tells where the
/// cursor is. The text must have passed find_bad_text.
class BlockScanner {
 public:
  struct Open {
    std::size_t block = 0;
    std::vector<std::string_view> given;  ///< labels of attributes so far
  };

  BlockScanner(std::string_view text, const Vocabulary& vocabulary)
      : text_(text), vocabulary_(vocabulary), tree_{text, {}, {}}, tokens_("", tree_, unheard_) {}

  /// Reads to the end of the text; what is not closed there stays open.
  void run();
  void close_all() { close_down_to(0); }

  [[nodiscard]] const std::vector<Block>& blocks() const noexcept { return blocks_; }
  /// Blocks that are still open, the innermost last.
  [[nodiscard]] const std::vector<Open>& open() const noexcept { return open_; }
  /// The attribute that was begun last in the innermost block, and its values so far.
  [[nodiscard]] std::string_view attribute() const noexcept { return attribute_; }
  [[nodiscard]] const std::vector<std::string_view>& values() const noexcept { return values_; }
  /// The last token; kEndOfFile before the first.
  [[nodiscard]] const Token& last() const noexcept { return last_; }

 private:
  void step();
  void label();
  void component_label();
  void value();
  void begin_attribute();
  void open_block(BlockKind kind);
  void open_section();
  void take_end_word();
  void close_last();
  void close_down_to(std::size_t depth);
  Token take();
  [[nodiscard]] bool inside(BlockKind kind) const noexcept { return depth_behind(kind) > 0; }
  /// How many blocks are open from the outermost to the innermost of this kind; 0: none is.
  [[nodiscard]] std::size_t depth_behind(BlockKind kind) const noexcept;
  [[nodiscard]] const Block* innermost() const noexcept {
    return open_.empty() ? nullptr : &blocks_[open_.back().block];
  }
  [[nodiscard]] bool is_attribute_of_innermost() const noexcept;
  [[nodiscard]] bool begins_section() const noexcept;
  [[nodiscard]] std::size_t offset_of(const Token& token) const noexcept {
    return static_cast<std::size_t>(token.text.data() - text_.data());
  }

  std::string_view text_;
  const Vocabulary& vocabulary_;
  Diagnostics unheard_;
  ParseTree tree_;
  TokenStream tokens_;
  std::vector<Block> blocks_;
  std::vector<Open> open_;
  std::string_view attribute_;
  std::vector<std::string_view> values_;
  Token last_;
  std::size_t last_end_ = 0;
};

/// All blocks of a text; the end of the text closes what is open.
[[nodiscard]] std::vector<Block> blocks_of(std::string_view text, const Vocabulary& vocabulary);

}  // namespace galilean::bhdl::lsp
