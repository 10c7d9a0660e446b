// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/keys.h"

#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace galilean::monitor::top {
namespace {

constexpr char kEsc = '\x1b';
constexpr char kCtrlX = '\x18';
constexpr std::size_t kLongestSequence = 32;
constexpr std::size_t kOldMouse = 6;  ///< bytes of ESC [ M, the button, the column and the row

Key key_of_final(char last) {
  constexpr std::array<std::pair<char, Key>, 6> kKeys{{{'A', Key::kUp},
                                                       {'B', Key::kDown},
                                                       {'C', Key::kRight},
                                                       {'D', Key::kLeft},
                                                       {'H', Key::kHome},
                                                       {'F', Key::kEnd}}};
  for (const auto& [letter, key] : kKeys)
    if (letter == last) return key;
  return Key::kOther;
}

Key key_of_number(std::string_view parameters) {
  const auto number = parameters.substr(0, parameters.find(';'));
  if (number == "5") return Key::kPageUp;
  if (number == "6") return Key::kPageDown;
  if (number == "1" || number == "7") return Key::kHome;
  if (number == "4" || number == "8") return Key::kEnd;
  return Key::kOther;
}

std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (wrong != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (!text.empty()) text.remove_prefix(1);
  return number;
}

/// Reads what stands between "ESC [ <" and the final M (pressed) or m (released).
Press mouse_press(std::string_view parameters, char last) {
  constexpr int kLeftButton = 0, kWheel = 64, kButtons = 0b11000011;
  const auto button = take_number(parameters), column = take_number(parameters),
             row = take_number(parameters);
  if (!button || !column || !row || last != 'M') return {Key::kOther};
  Press press{Key::kOther, 0, *row - 1, *column - 1};
  if ((*button & kButtons) == kLeftButton && (*button & 32) == 0) press.key = Key::kClick;
  if ((*button & kButtons) == kWheel) press.key = Key::kWheelUp;
  if ((*button & kButtons) == kWheel + 1) press.key = Key::kWheelDown;
  return press;
}

Press press_of(std::string_view parameters, char last) {
  if (parameters.starts_with('<') && (last == 'M' || last == 'm'))
    return mouse_press(parameters.substr(1), last);
  if (last == '~') return {key_of_number(parameters)};
  return {key_of_final(last)};
}

Press press_of_byte(char byte) {
  switch (byte) {
    case '\t':
      return {Key::kTab};
    case '\r':
    case '\n':
      return {Key::kEnter};
    case '\b':
    case '\x7f':
      return {Key::kBackspace};
    case kCtrlX:
      return {Key::kStop};
    default:
      break;
  }
  if (byte >= ' ' && byte <= '~') return {Key::kLetter, byte};
  return {Key::kOther};
}

/// Returns whether the byte is a key that stops all robots, which no terminal sends in a sequence.
bool is_stop(char byte) {
  return byte == '.' || byte == kCtrlX;
}

}  // namespace

Press KeyReader::take(bool is_all) {
  if (bytes_.empty()) return {};
  if (bytes_[0] == kEsc) return take_sequence(is_all);
  return take_first(1, press_of_byte(bytes_[0]));
}

Press KeyReader::take_first(std::size_t count, const Press& press) {
  bytes_.erase(0, count);
  return press;
}

Press KeyReader::take_sequence(bool is_all) {
  if (bytes_.size() == 1) return is_all ? take_first(1, {Key::kEscape}) : Press{};
  if (bytes_[1] == kEsc || is_stop(bytes_[1])) return take_first(1, {Key::kEscape});
  if (bytes_[1] == 'O') {
    if (bytes_.size() >= 3 && is_stop(bytes_[2])) return take_first(2, {Key::kOther});
    if (bytes_.size() >= 3) return take_first(3, {key_of_final(bytes_[2])});
    return is_all ? take_first(2, {Key::kOther}) : Press{};
  }
  if (bytes_[1] != '[') return take_first(2, {Key::kOther});  // Alt with a letter
  if (bytes_.size() >= 3 && bytes_[2] == 'M') {
    if (bytes_.size() < kOldMouse && !is_all) return {};
    return take_first(kOldMouse, {Key::kOther});
  }
  for (std::size_t at = 2; at < bytes_.size(); ++at) {
    const char byte = bytes_[at];
    if (byte >= '@' && byte <= '~')
      return take_first(at + 1, press_of(std::string_view(bytes_).substr(2, at - 2), byte));
    if (byte < ' ' || is_stop(byte) || at > kLongestSequence) return take_first(at, {Key::kOther});
  }
  return is_all ? take_first(bytes_.size(), {Key::kOther}) : Press{};
}

}  // namespace galilean::monitor::top
