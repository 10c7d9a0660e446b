// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace galilean::bhdl::lsp {

/// The unit in which a client counts the characters of a line.
enum class PositionEncoding { kUtf8, kUtf16, kUtf32 };
[[nodiscard]] std::string_view to_string(PositionEncoding encoding) noexcept;
[[nodiscard]] std::optional<PositionEncoding> find_encoding(std::string_view name) noexcept;

/// A place in the form of the protocol. Both numbers count from 0.
struct TextPosition {
  std::size_t line = 0;
  std::size_t character = 0;
};

/// The bytes from `begin` up to but without `end`.
struct ByteRange {
  std::size_t begin = 0;
  std::size_t end = 0;

  /// Returns whether the cursor is at the range. The end counts as inside, because a cursor behind
  /// a word's last letter is at the word.
  [[nodiscard]] bool touches(std::size_t offset) const noexcept {
    return begin <= offset && offset <= end;
  }
};

/// Where the lines of a text begin. Lines end at \n, \r\n and \r, as in BHDL and in the protocol.
/// The text must outlive the index.
class TextIndex {
 public:
  explicit TextIndex(std::string_view text);

  /// Returns a place in bytes. A place behind a line's end means that end, and one behind the text
  /// means the text's end.
  [[nodiscard]] std::size_t offset(TextPosition at, PositionEncoding encoding) const noexcept;
  [[nodiscard]] TextPosition position(std::size_t offset, PositionEncoding encoding) const noexcept;
  /// Returns the place that a diagnostic names. Line and column count from 1, columns in
  /// characters, without a byte order mark.
  [[nodiscard]] std::size_t offset_of_place(int line, int column) const noexcept;
  /// Returns the number of the line, from 0.
  [[nodiscard]] std::size_t line_of(std::size_t offset) const noexcept;
  /// Returns the text of a line without its line end.
  [[nodiscard]] std::string_view line(std::size_t number) const noexcept;
  /// Returns whether a line holds a comment and nothing else.
  [[nodiscard]] bool is_comment_line(std::size_t number) const noexcept;
  [[nodiscard]] std::size_t line_count() const noexcept { return starts_.size(); }
  /// Returns where `part` stands. Requires: `part` is a part of this very text.
  [[nodiscard]] ByteRange range_of(std::string_view part) const noexcept {
    const auto begin = static_cast<std::size_t>(part.data() - text_.data());
    return {begin, begin + part.size()};
  }

 private:
  std::string_view text_;
  std::vector<std::uint32_t> starts_;
};

}  // namespace galilean::bhdl::lsp
