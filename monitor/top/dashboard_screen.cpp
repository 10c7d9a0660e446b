// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/dashboard.h"

namespace galilean::monitor::top {

View Dashboard::view() {
  const DashboardModel& model = past_ ? past_->model() : model_;
  const Clock& clock = past_ ? past_->clock() : clock_;
  View made = make_view(
      {model, clock, model_.identities(), &curves_, &board_, past_ ? &clock_ : nullptr}, choice_);
  for (auto& robot : made.robots)
    if (const auto lease = pusher_.lease(robot.status.name); lease && !lease->is_yours)
      robot.steered_by = lease->holder;
  return made;
}

Surroundings Dashboard::surroundings() const {
  Surroundings around{.tab = tab_, .scrolls = scrolls_};
  around.banner = steering_.stop_report();
  if (around.banner.empty()) around.banner = asked_for();
  if (!around.banner.empty()) around.banner.insert(0, of_now());
  around.footer = footer();
  if (instant_)
    around.remark = lasting(to_seconds(clock_.now() - *instant_)) + " ago (l: now)";
  else if (!pusher_.hindrance().empty())
    around.remark = "cannot push";
  return around;
}

std::string Dashboard::of_now() const {
  return past_ ? "now: " : "";
}

std::string Dashboard::footer() const {
  if (mode_ == Mode::kQuestion) return of_now() + question_ + " y / n   . STOP ALL";
  if (mode_ == Mode::kFile) return "Push which file? " + file_ + "_  Enter, Esc, Ctrl-X STOP ALL";
  if (mode_ == Mode::kReason)
    return "Why take " + wanted_robot_ + " over? " + reason_ + "_  Enter, Esc, Ctrl-X STOP ALL";
  if (mode_ == Mode::kFilter)
    return std::string(tab_ == Tab::kVariables ? "Variables" : "Robots") +
           " with: " + (tab_ == Tab::kVariables ? choice_.variable_filter : choice_.robot_filter) +
           "_  Enter keeps it, Esc shows all, Ctrl-X STOP ALL";
  return notices_.shown(past_ != nullptr);
}

Canvas Dashboard::draw(int columns, int rows) {
  const View shown = view();
  drawn_robot_ = shown.robots.empty() ? std::string() : shown.robots[shown.chosen].status.name;
  Screen screen = lay_out(shown, surroundings(), columns, rows);
  regions_ = std::move(screen.regions);
  shown_alarms_ = std::move(screen.alarms);
  is_too_small_ = columns < kLeastColumns || rows < kLeastRows;
  if (!is_too_small_) scrolls_ = screen.scrolls;
  if (mode_ == Mode::kSheet) sheet_->lay_over(notices_.shown(past_ != nullptr), screen.canvas);
  return std::move(screen.canvas);
}

}  // namespace galilean::monitor::top
