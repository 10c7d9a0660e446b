// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/text_index.h"

#include <algorithm>
#include <array>

#include "bhdl/source/text.h"

namespace galilean::bhdl::lsp {
namespace {

constexpr std::array<std::string_view, 3> kEncodings{"utf-8", "utf-16", "utf-32"};
constexpr std::string_view kMark = "\uFEFF";

// A byte that breaks UTF-8 counts as one character, so that every text has positions.
std::size_t bytes_of_first(std::string_view text) noexcept {
  return std::max<std::size_t>(1, character_size(text));
}

std::size_t units_of(std::size_t bytes, PositionEncoding encoding) noexcept {
  constexpr std::size_t kBytesBeyondBasicPlane = 4;
  if (encoding == PositionEncoding::kUtf8) return bytes;
  return encoding == PositionEncoding::kUtf16 && bytes == kBytesBeyondBasicPlane ? 2 : 1;
}

// A position inside a character means the beginning of the character.
std::size_t bytes_of_units(std::string_view line, std::size_t units, PositionEncoding encoding) {
  std::size_t bytes = 0;
  while (bytes < line.size()) {
    const std::size_t size = bytes_of_first(line.substr(bytes));
    const std::size_t taken = units_of(size, encoding);
    if (taken > units) break;
    units -= taken;
    bytes += size;
  }
  return bytes;
}

}  // namespace

std::string_view to_string(PositionEncoding encoding) noexcept {
  return kEncodings[static_cast<std::size_t>(encoding)];
}

std::optional<PositionEncoding> find_encoding(std::string_view name) noexcept {
  const auto found = std::ranges::find(kEncodings, name);
  if (found == kEncodings.end()) return std::nullopt;
  return static_cast<PositionEncoding>(found - kEncodings.begin());
}

TextIndex::TextIndex(std::string_view text) : text_(text), starts_{0} {
  // Nearly no text has \r, and searching for one byte is many times faster than for two.
  const bool plain = text.find('\r') == std::string_view::npos;
  const auto next_end = [&](std::size_t from) {
    return plain ? text.find('\n', from) : text.find_first_of("\r\n", from);
  };
  for (std::size_t at = next_end(0); at != std::string_view::npos; at = next_end(at)) {
    at += text.substr(at).starts_with("\r\n") ? 2 : 1;
    starts_.push_back(static_cast<std::uint32_t>(at));
  }
}

std::size_t TextIndex::line_of(std::size_t offset) const noexcept {
  const auto behind = std::upper_bound(starts_.begin() + 1, starts_.end(), offset);
  return static_cast<std::size_t>(behind - starts_.begin()) - 1;
}

std::string_view TextIndex::line(std::size_t number) const noexcept {
  const std::size_t end = number + 1 < starts_.size() ? starts_[number + 1] : text_.size();
  auto whole = text_.substr(starts_[number], end - starts_[number]);
  while (whole.ends_with('\n') || whole.ends_with('\r')) whole.remove_suffix(1);
  return whole;
}

bool TextIndex::is_comment_line(std::size_t number) const noexcept {
  const auto text = line(number);
  const auto content = text.find_first_not_of(" \t");
  return content != std::string_view::npos && text[content] == ';';
}

std::size_t TextIndex::offset(TextPosition at, PositionEncoding encoding) const noexcept {
  if (at.line >= starts_.size()) return text_.size();
  return starts_[at.line] + bytes_of_units(line(at.line), at.character, encoding);
}

TextPosition TextIndex::position(std::size_t offset, PositionEncoding encoding) const noexcept {
  const std::size_t number = line_of(std::min(offset, text_.size()));
  const std::string_view whole = line(number);
  const std::size_t end = std::min(offset - starts_[number], whole.size());
  std::size_t units = 0;
  for (std::size_t at = 0; at < end;) {
    const std::size_t size = bytes_of_first(whole.substr(at));
    if (at + size > end) break;
    units += units_of(size, encoding);
    at += size;
  }
  return {number, units};
}

std::size_t TextIndex::offset_of_place(int line_number, int column) const noexcept {
  const auto index = static_cast<std::size_t>(std::max(line_number, 1)) - 1;
  auto characters = static_cast<std::size_t>(std::max(column, 1)) - 1;
  if (index == 0 && text_.starts_with(kMark)) ++characters;
  return offset({index, characters}, PositionEncoding::kUtf32);
}

}  // namespace galilean::bhdl::lsp
