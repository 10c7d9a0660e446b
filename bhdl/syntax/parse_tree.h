// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <iterator>
#include <string_view>
#include <vector>

#include "bhdl/syntax/token.h"

namespace galilean::bhdl {

/// The kinds of nodes, in GRAMMAR.md's words.
enum class NodeKind : std::uint8_t {
  kSection,  ///< `sense`: the ComponentKind
  kComponent,
  kStates,
  kState,
  kSchemaList,  ///< `sense`: the ComponentKind of its schemas
  kCondition,
  kDefine,
  kExpect,
  kStep,
  kOnSwap,
  kSwap,        ///< "old": "new"; fewer than three tokens if one is missing
  kInclude,     ///< without a text if the path is missing
  kStartState,  ///< without a text if the name is missing
  kAttribute,   ///< without a value if that is missing
  kValue,       ///< `sense`: a ValueSense
  kError        ///< tokens that have no place in the grammar
};

enum class ValueSense : std::uint8_t { kPlain, kPair, kBroken };

/// A part of a file: the tokens from `first_token` up to but without `end_token`. Its inner nodes
/// follow it directly. Its next sibling follows behind them, at `end_node`.
struct Node {
  NodeKind kind = NodeKind::kError;
  std::uint8_t sense = 0;
  std::uint32_t first_token = 0;
  std::uint32_t end_token = 0;
  std::uint32_t end_node = 0;
};

/// A node's children, as indices of nodes.
class NodeRange {
 public:
  class Iterator {
   public:
    using value_type = std::uint32_t;
    using difference_type = std::ptrdiff_t;
    Iterator() = default;
    Iterator(const std::vector<Node>& nodes, std::uint32_t at) : nodes_(&nodes), at_(at) {}
    std::uint32_t operator*() const noexcept { return at_; }
    Iterator& operator++() noexcept {
      at_ = (*nodes_)[at_].end_node;
      return *this;
    }
    Iterator operator++(int) noexcept {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator& other) const noexcept { return at_ == other.at_; }

   private:
    const std::vector<Node>* nodes_ = nullptr;
    std::uint32_t at_ = 0;
  };

  NodeRange(const std::vector<Node>& nodes, std::uint32_t first, std::uint32_t end)
      : nodes_(&nodes), first_(first), end_(end) {}
  [[nodiscard]] Iterator begin() const noexcept { return {*nodes_, first_}; }
  [[nodiscard]] Iterator end() const noexcept { return {*nodes_, end_}; }

 private:
  const std::vector<Node>* nodes_;
  std::uint32_t first_;
  std::uint32_t end_;
};

/// The text of a file and its parts. Nothing of the text is lost: the tokens in order, each with
/// the trivia before it (trivia.h), are the text, whatever it is.
///
/// Both arrays are flat and in the order of the text. A node comes before its children. The tokens
/// point into the text, which must outlive the tree.
struct ParseTree {
  std::string_view text;
  std::vector<Token> tokens;  ///< the last is the end of the file, and no other is
  std::vector<Node> nodes;

  [[nodiscard]] NodeRange roots() const noexcept {
    return {nodes, 0, static_cast<std::uint32_t>(nodes.size())};
  }
  [[nodiscard]] NodeRange children(std::uint32_t node) const noexcept {
    return {nodes, node + 1, nodes[node].end_node};
  }
  [[nodiscard]] const Token& first_token(const Node& node) const noexcept {
    return tokens[node.first_token];
  }
  /// Returns the byte at which a part of the text begins.
  [[nodiscard]] std::size_t offset_of(std::string_view part) const noexcept {
    return static_cast<std::size_t>(part.data() - text.data());
  }
  /// Returns the blanks, comments and skipped bytes between this token and the one before it.
  [[nodiscard]] std::string_view gap_before(std::size_t token) const noexcept;
};

}  // namespace galilean::bhdl
