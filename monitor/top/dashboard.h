// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "monitor/orders/operator.h"
#include "monitor/top/model/past.h"
#include "monitor/top/model/stop_order.h"
#include "monitor/top/model/view.h"
#include "monitor/top/panels/layout.h"
#include "monitor/top/pusher.h"
#include "monitor/top/screen/keys.h"

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
    /// Tells robots a word, or all robots if there are no names. Returns false if that failed.
    std::function<bool(Operator::Word, const std::vector<std::string>& robots)> say;
    Pusher& pusher;
  };

  Dashboard(Parts parts, std::string chosen);

  /// Looks for alarms, and tells again those that have not confirmed the order to stop. Call it
  /// some times a second.
  void update();
  /// Handles a key. Returns false if it was the key to quit.
  [[nodiscard]] bool press(const Press& press);
  [[nodiscard]] Canvas draw(int columns, int rows);

 private:
  enum class Mode { kTeam, kHelp, kQuestion, kFilter, kFile, kPush };

  bool press_letter(char letter);
  void press_with_team(const Press& press);
  /// Returns whether the key is to stop all robots. Where a text is typed, a dot is one only as the
  /// first key, because it may belong to the text.
  [[nodiscard]] bool stops_all(const Press& press) const noexcept;
  [[nodiscard]] bool types() const noexcept;
  void begin_text(Mode mode);
  void press_with_text(const Press& press);
  void press_with_sheet(const Press& press);
  void click(const Press& press);
  void scroll(Panel panel, int lines);
  void choose(std::size_t number);
  void move(int step);
  /// Chooses the first robot until all have had time to be heard, unless somebody chose one.
  void settle(Time now);
  [[nodiscard]] View view() const;
  [[nodiscard]] Surroundings surroundings() const;
  [[nodiscard]] std::string& typed();

  void go_back(Duration step);
  void go_to(std::optional<Time> instant);
  // Only what stood on the screen can have been seen.
  void acknowledge_first();
  void acknowledge_shown();

  /// Returns the name of the robot that is shown, or an empty text where none is heard.
  [[nodiscard]] std::string shown_robot() const;
  void say(Operator::Word word, const std::string& robot, bool to_all);
  void ask(std::string question, std::function<void()> yes);
  void answer(char letter);
  void stop_all();
  /// Takes those that are resumed out of the order to stop.
  void end_stop_of(const std::string& robot, bool of_all);
  void begin_push(bool last_good, bool to_all);
  void check(const std::string& file);
  void press_with_push(const Press& press);
  [[nodiscard]] std::string push_keys(const PushReport& report) const;
  void tell(std::string notice);

  Parts parts_;
  AlarmFinder finder_;
  AlarmBoard board_;
  Choice choice_;
  bool is_settled_ = false;  ///< the choice stays, whoever is heard
  std::optional<Time> first_heard_;
  Mode mode_ = Mode::kTeam;
  Tab tab_ = Tab::kAll;
  Scrolls scrolls_;
  std::vector<Region> regions_;
  std::vector<AlarmLine> shown_alarms_;
  Sheet help_;
  int push_scroll_ = 0;
  std::optional<Time> instant_;  ///< none: the present
  std::unique_ptr<Past> past_;
  std::string notice_;
  Time noticed_{};
  std::string question_;
  std::function<void()> yes_;
  std::string file_;
  bool has_typed_ = false;     ///< since the text was asked for
  bool is_too_small_ = false;  ///< nobody sees what is asked or typed
  PushWish wish_;
  bool with_canary_ = false;
  std::optional<StopOrder> stop_order_;
  Time stop_told_{};
  std::optional<Time> all_stopped_;
};

}  // namespace galilean::monitor::top
