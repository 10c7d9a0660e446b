// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "monitor/top/model/past.h"
#include "monitor/top/model/view.h"
#include "monitor/top/panels/layout.h"
#include "monitor/top/push/pusher.h"
#include "monitor/top/screen/keys.h"
#include "monitor/top/sheets/open_sheet.h"
#include "monitor/top/steering/steering.h"

namespace galilean::monitor::top {

/// The dashboard's state: what is chosen, filtered, scrolled and asked. Keys change it and give
/// orders to robots.
class Dashboard {
 public:
  /// What the dashboard shows and what it steers with.
  struct Parts {
    const DashboardModel& model;
    const History& history;
    const Clock& clock;
    Voice voice;
    Pusher& pusher;
  };

  Dashboard(const Parts& parts, std::string chosen);

  /// Looks for alarms, and for what became of orders. Call it some times a second.
  void update();
  /// Handles a key. Returns false if it was the key to quit.
  [[nodiscard]] bool press(const Press& press);
  [[nodiscard]] Canvas draw(int columns, int rows);
  /// Returns the name of the robot that the last screen showed; empty where none was heard.
  [[nodiscard]] const std::string& drawn_robot() const noexcept { return drawn_robot_; }

 private:
  enum class Mode { kTeam, kSheet, kQuestion, kFilter, kFile, kReason };

  // dashboard_keys.cpp: what a key means.
  void press_letter(char letter);
  void press_with_team(const Press& press);
  void press_with_text(const Press& press);
  void press_with_sheet(const Press& press);
  /// Returns whether the key is to stop all robots. Where a text is typed, a dot is one only as the
  /// first key, because it may belong to the text.
  [[nodiscard]] bool stops_all(const Press& press) const noexcept;
  [[nodiscard]] bool types() const noexcept;
  [[nodiscard]] std::string& typed();
  void answer(char letter);

  // dashboard.cpp: what is shown.
  void click(const Press& press);
  void scroll(Panel panel, int lines);
  void choose(std::size_t number);
  void move(int step);
  /// Chooses the first robot until all have had time to be heard, unless somebody chose one.
  void settle(Time now);
  void go_back(Duration step);
  void go_to(std::optional<Time> instant);
  // Only what stood on the screen can have been seen.
  void acknowledge_first();
  void acknowledge_shown();

  // dashboard_orders.cpp: what is ordered.
  /// Returns the name of the robot that is shown, or an empty text where none is heard.
  [[nodiscard]] std::string shown_robot();
  void ask(std::string question, std::function<void()> yes);
  void ask_to_resume(bool all);
  /// Asks whether to take the shown robot out of service, or to put it into service again.
  void ask_about_service();
  void begin_text(Mode mode);
  void begin_push(bool last_good, bool to_all);
  void open_history(bool to_all);
  void open_gains(bool to_all);
  /// Tells why nothing can be pushed. Returns false if something can.
  bool tells_hindrance();
  /// Returns a wish to push to the shown robot, or to all. Requires: a robot is shown.
  [[nodiscard]] PushWish wish_for(bool to_all);
  void open(std::unique_ptr<OpenSheet> sheet);

  // dashboard_breaks.cpp: where the shown robot stops.
  /// Chooses the state above or below the chosen one, at first the present one.
  void move_in_machine(int step);
  void toggle_break_point();
  void open_breaks();

  // dashboard_leases.cpp: who steers.
  /// Asks for the shown robot, or gives it to who asks for it.
  void take_turns();
  /// Begins to take the shown robot over, or refuses it to who asks for it.
  void insist();
  void take_over();
  /// Returns whether no other operator holds the robot, or any robot of the team. Tells if one
  /// does.
  bool may_steer(const std::string& robot, bool all);
  /// Returns who asks for one of this operator's robots, and what answers; mostly empty.
  [[nodiscard]] std::string asked_for() const;

  // dashboard_screen.cpp: how it looks.
  [[nodiscard]] View view();
  [[nodiscard]] Surroundings surroundings() const;
  [[nodiscard]] std::string footer() const;
  /// Returns what stands before the present's sentences while the past is shown.
  [[nodiscard]] std::string of_now() const;

  const DashboardModel& model_;
  const History& history_;
  const Clock& clock_;
  Pusher& pusher_;
  NoticeBoard notices_;
  Steering steering_;
  AlarmFinder finder_;
  AlarmBoard board_;
  Curves curves_;
  Choice choice_;
  bool is_settled_ = false;  ///< the choice stays, whoever is heard
  std::optional<Time> first_heard_;
  Mode mode_ = Mode::kTeam;
  std::unique_ptr<OpenSheet> sheet_;  ///< in Mode::kSheet
  Tab tab_ = Tab::kAll;
  Scrolls scrolls_;
  std::string drawn_robot_;
  std::vector<Region> regions_;
  std::vector<AlarmLine> shown_alarms_;
  std::optional<Time> instant_;  ///< none: the present
  std::unique_ptr<Past> past_;
  std::string question_;
  std::function<void()> yes_;
  std::string file_;
  std::string reason_, wanted_robot_;  ///< in Mode::kReason
  bool has_typed_ = false;             ///< since the text was asked for
  bool is_too_small_ = false;          ///< nobody sees what is asked or typed
  PushWish wish_;                      ///< in Mode::kFile: of the program whose file is typed
};

}  // namespace galilean::monitor::top
