// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/problems/escapes.h"

#include "core/visible_text.h"

namespace galilean::expect {

std::string xml_text(const std::string& text) {
  std::string safe;
  for (const char c : visible(text)) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string xml_attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + xml_text(value) + "\"";
}

std::string command_text(const std::string& text, bool property) {
  std::string safe;
  for (const char c : text) {
    if (c == '%')
      safe += "%25";
    else if (c == '\r')
      safe += "%0D";
    else if (c == '\n')
      safe += "%0A";
    else if (c == ':' && property)
      safe += "%3A";
    else if (c == ',' && property)
      safe += "%2C";
    else
      safe += c;
  }
  return safe;
}

std::string tap_description(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '#' || c == '\\') safe += '\\';
    safe += c;
  }
  return safe;
}

}  // namespace galilean::expect
