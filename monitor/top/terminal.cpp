// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/terminal.h"

#include <langinfo.h>
#include <ncurses.h>
#include <unistd.h>

#include <array>
#include <clocale>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "monitor/top/utf8.h"

namespace galilean::monitor::top {
namespace {

/// The nearest of 256 colours to those of Okabe and Ito, which colour-blind people can tell apart.
constexpr std::array<short, kRobotStyles> kRobotColours{74, 214, 36, 175, 25, 227};
constexpr std::array<short, kRobotStyles> kRobotColoursOf8{
    COLOR_CYAN, COLOR_YELLOW, COLOR_GREEN, COLOR_MAGENTA, COLOR_BLUE, COLOR_WHITE};
constexpr short kRobotPair = 10;
enum Pair : short { kWarningPair = 1, kAlarmPair, kTrashPair, kBasketPair, kCurrentPair };

void use_utf8() {
  std::setlocale(LC_ALL, "");
  if (std::strcmp(nl_langinfo(CODESET), "UTF-8") != 0) std::setlocale(LC_ALL, "C.UTF-8");
}

void use_colours() {
  const char* refused = std::getenv("NO_COLOR");
  if ((refused && *refused) || !has_colors()) return;
  start_color();
  use_default_colors();
  init_pair(kWarningPair, COLOR_YELLOW, -1);
  init_pair(kAlarmPair, COLOR_RED, -1);
  init_pair(kTrashPair, COLOR_RED, -1);
  init_pair(kBasketPair, COLOR_GREEN, -1);
  init_pair(kCurrentPair, COLOR_CYAN, -1);
  const auto& colours = COLORS >= 256 ? kRobotColours : kRobotColoursOf8;
  for (short i = 0; i < kRobotStyles; ++i)
    init_pair(static_cast<short>(kRobotPair + i), colours[static_cast<std::size_t>(i)], -1);
}

attr_t pair(int number) {
  return static_cast<attr_t>(COLOR_PAIR(number));
}

attr_t attributes(Style style) {
  switch (style) {
    case Style::kPlain:
    case Style::kObstacle:
      return A_NORMAL;
    case Style::kDim:
      return A_DIM;
    case Style::kBold:
      return A_BOLD;
    case Style::kHeading:
      return A_UNDERLINE;
    case Style::kCurrent:
      return A_BOLD | A_REVERSE | pair(kCurrentPair);
    case Style::kWarning:
      return pair(kWarningPair);
    case Style::kAlarm:
      return A_BOLD | pair(kAlarmPair);
    case Style::kTrash:
      return A_BOLD | pair(kTrashPair);
    case Style::kBasket:
      return pair(kBasketPair);
    case Style::kRobot:
      break;
  }
  const int robot = static_cast<int>(style) - static_cast<int>(Style::kRobot);
  return A_BOLD | pair(kRobotPair + robot);
}

}  // namespace

Terminal::Terminal() {
  use_utf8();
  if (!isatty(STDOUT_FILENO) || !newterm(nullptr, stdout, stdin))
    throw std::runtime_error(
        "standard output is not a terminal that can be drawn on; --once prints plain text");
  use_colours();
  cbreak();
  noecho();
  curs_set(0);
  keypad(stdscr, TRUE);
  nodelay(stdscr, TRUE);
  set_escdelay(25);
}

Terminal::~Terminal() {
  endwin();
}

int Terminal::columns() const {
  return getmaxx(stdscr);
}
int Terminal::rows() const {
  return getmaxy(stdscr);
}

void Terminal::show(const Canvas& canvas) {
  erase();
  for (int row = 0; row < canvas.rows(); ++row) {
    for (int column = 0; column < canvas.columns(); ++column) {
      const Cell& cell = canvas.at(row, column);
      std::string glyph;
      append_utf8(glyph, cell.glyph);
      attrset(static_cast<int>(attributes(cell.style)));
      mvaddstr(row, column, glyph.c_str());
    }
  }
  refresh();
}

Terminal::Press Terminal::take_key() {
  const int key = getch();
  switch (key) {
    case ERR:
      return {};
    case KEY_UP:
      return {Key::kUp};
    case KEY_DOWN:
      return {Key::kDown};
    case KEY_RESIZE:
      return {Key::kResized};
    default:
      return {Key::kOther, key < 128 ? static_cast<char>(key) : '\0'};
  }
}

}  // namespace galilean::monitor::top
