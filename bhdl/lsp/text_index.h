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

/// Bytes from `begin` up to, without, `end`.
struct ByteRange {
  std::size_t begin = 0;
  std::size_t end = 0;

  /// An end counts as inside: a cursor behind a word's last letter is at the word.
  [[nodiscard]] bool touches(std::size_t offset) const noexcept {
    return begin <= offset && offset <= end;
  }
};

/// Where the lines of a text begin. Lines end at \n, \r\n and \r, as in BHDL and in the protocol.
/// The text must outlive the index.
class TextIndex {
 public:
  explicit TextIndex(std::string_view text);

  /// In bytes. A place behind a line's end is its end, one behind the text is the text's end.
  [[nodiscard]] std::size_t offset(TextPosition at, PositionEncoding encoding) const noexcept;
  [[nodiscard]] TextPosition position(std::size_t offset, PositionEncoding encoding) const noexcept;
  /// The place that a diagnostic names: line and column from 1, columns in characters, a byte order
  /// mark not counted.
  [[nodiscard]] std::size_t offset_of_place(int line, int column) const noexcept;
  /// Returns the number of the line, from 0.
  [[nodiscard]] std::size_t line_of(std::size_t offset) const noexcept;
  /// Returns the text of a line without its line end.
  [[nodiscard]] std::string_view line(std::size_t number) const noexcept;
  /// Returns whether a line holds a comment and nothing else.
  [[nodiscard]] bool is_comment_line(std::size_t number) const noexcept;
  [[nodiscard]] std::size_t line_count() const noexcept { return starts_.size(); }
  /// Where `part`, which is a part of this very text, stands in it.
  [[nodiscard]] ByteRange range_of(std::string_view part) const noexcept {
    const auto begin = static_cast<std::size_t>(part.data() - text_.data());
    return {begin, begin + part.size()};
  }

 private:
  std::string_view text_;
  std::vector<std::uint32_t> starts_;
};

}  // namespace galilean::bhdl::lsp
