// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/manual/roff.h"

#include <cstdint>
#include <cstdio>

namespace galilean::front {
namespace {

/// Returns the code point that begins at `at`, and moves `at` behind it. Requires: valid UTF-8.
std::uint32_t take_code_point(const std::string& text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at++]);
  if (first < 0x80) return first;
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
  std::uint32_t code = first & (0x3Fu >> more);
  for (int i = 0; i < more && at < text.size(); ++i)
    code = (code << 6) | (static_cast<unsigned char>(text[at++]) & 0x3Fu);
  return code;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::uint32_t code = take_code_point(text, at);
    if (code == '\\')
      result += "\\e";
    else if (code == '-')
      result += "\\-";
    else if (code == '\'')
      result += "\\(aq";
    else if (code == '^')
      result += "\\(ha";
    else if (code == '~')
      result += "\\(ti";
    else if (code == '`')
      result += "\\(ga";
    else if (code < 0x80)
      result += static_cast<char>(code);
    else {
      char name[16];
      std::snprintf(name, sizeof name, "\\[u%04X]", code);
      result += name;
    }
  }
  return result;
}

/// Returns a line that does not begin like one of roff's requests.
std::string text_line(const std::string& line) {
  return (line.starts_with('.') ? "\\&" : "") + line + "\n";
}

}  // namespace

Roff::Roff(const std::string& name, const std::string& release) {
  std::string title = name;
  for (char& c : title)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  text_ = ".\\\" Made by `galilean manual`.\n.TH " + escaped(title) + " 1 \"\" \"" +
          escaped(release) + "\" \"Galilean\"\n";
}

void Roff::section(const std::string& title) {
  text_ += ".SH " + title + "\n";
}

void Roff::subsection(const std::string& title) {
  text_ += ".SS \"" + escaped(title) + "\"\n";
}

void Roff::paragraph(const std::string& text) {
  text_ += ".PP\n" + text_line(escaped(text));
}

void Roff::item(const std::string& term, const std::string& text) {
  text_ += ".TP\n" + text_line(term) + text_line(escaped(text));
}

void Roff::synopsis(const std::string& line) {
  text_ += text_line(line) + ".br\n";
}

std::string Roff::bold(const std::string& text) {
  return "\\fB" + escaped(text) + "\\fR";
}

std::string Roff::italic(const std::string& text) {
  return "\\fI" + escaped(text) + "\\fR";
}

std::string Roff::plain(const std::string& text) {
  return escaped(text);
}

}  // namespace galilean::front
