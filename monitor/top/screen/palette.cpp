// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/palette.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

namespace galilean::monitor::top {
namespace {

/// One colour as each kind of terminal has it.
struct Ink {
  std::uint8_t red, green, blue;
  std::uint8_t of_256;  ///< the nearest of the 256 colours
  std::uint8_t code;    ///< of the 16 colours: the code as foreground
};

// The robots' colours are those of the page: Okabe and Ito's, which the colour-blind tell apart.
constexpr std::array<Ink, kRobotStyles> kRobots{{{86, 180, 233, 74, 96},
                                                 {230, 159, 0, 214, 33},
                                                 {0, 158, 115, 36, 32},
                                                 {204, 121, 167, 175, 35},
                                                 {0, 114, 178, 25, 34},
                                                 {240, 228, 66, 227, 93}}};
constexpr std::size_t kDarkRobot = 4;  ///< its letter is white
constexpr Ink kBlackInk{17, 17, 17, 16, 30}, kWhiteInk{255, 255, 255, 231, 97};
constexpr Ink kWarningInk{222, 150, 40, 178, 33}, kAlarmInk{229, 83, 75, 203, 91};
constexpr Ink kGoodInk{63, 178, 127, 72, 32}, kAccentInk{74, 155, 222, 74, 36};
constexpr Ink kStopInk{196, 35, 28, 160, 31};

std::string colour_code(const Ink& ink, Colours colours, bool background) {
  const std::string ground = background ? "48" : "38";
  switch (colours) {
    case Colours::kNone:
      return {};
    case Colours::k16:
      return ";" + std::to_string(ink.code + (background ? 10 : 0));
    case Colours::k256:
      return ";" + ground + ";5;" + std::to_string(ink.of_256);
    case Colours::kTrue:
      break;
  }
  return ";" + ground + ";2;" + std::to_string(ink.red) + ";" + std::to_string(ink.green) + ";" +
         std::to_string(ink.blue);
}

std::string on_ground(const Ink& ink, const Ink& ground, Colours colours) {
  if (colours == Colours::kNone) return ";1;7";
  return ";1" + colour_code(ink, colours, false) + colour_code(ground, colours, true);
}

std::string attributes_of(Style style, Colours colours) {
  const auto in = [&](const Ink& ink) { return colour_code(ink, colours, false); };
  switch (style) {
    case Style::kPlain:
    case Style::kObstacle:
      return {};
    case Style::kDim:
      return ";2";
    case Style::kBold:
      return ";1";
    case Style::kHeading:
      return ";4";
    case Style::kCurrent:
      return ";1;7" + in(kAccentInk);
    case Style::kWarning:
      return in(kWarningInk);
    case Style::kAlarm:
      return ";1" + in(kAlarmInk);
    case Style::kGood:
    case Style::kBasket:
      return in(kGoodInk);
    case Style::kTrash:
      return ";1" + in(kAlarmInk);
    case Style::kStop:
      return on_ground(kWhiteInk, kStopInk, colours);
    case Style::kRobot:
      break;
  }
  const auto robot = static_cast<std::size_t>(style) - static_cast<std::size_t>(Style::kRobot);
  return on_ground(robot == kDarkRobot ? kWhiteInk : kBlackInk, kRobots[robot], colours);
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::string process_environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

Colours colours_of(const Environment& environment) {
  if (!environment("NO_COLOR").empty()) return Colours::kNone;
  const std::string term = environment("TERM"), wide = environment("COLORTERM");
  if (wide == "truecolor" || wide == "24bit" || term.ends_with("-direct")) return Colours::kTrue;
  if (term.find("256color") != term.npos) return Colours::k256;
  if (term.empty() || term == "dumb" || term.starts_with("vt") || term.ends_with("-m") ||
      term.ends_with("-mono"))
    return Colours::kNone;
  return Colours::k16;
}

bool is_utf8(const Environment& environment) {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const std::string locale = lower(environment(name));
    if (locale.empty()) continue;
    return locale.find("utf-8") != locale.npos || locale.find("utf8") != locale.npos;
  }
  return false;
}

std::string escape_sequence(Style style, Colours colours) {
  return "\x1b[0" + attributes_of(style, colours) + "m";
}

}  // namespace galilean::monitor::top
