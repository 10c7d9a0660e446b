// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "monitor/top/dashboard.h"
#include "monitor/top/sheets/gain_sheet.h"
#include "monitor/top/sheets/history_sheet.h"
#include "monitor/top/sheets/push_sheet.h"

namespace galilean::monitor::top {

std::string Dashboard::shown_robot() {
  const View shown = view();
  return shown.robots.empty() ? std::string() : shown.robots[shown.chosen].status.name;
}

void Dashboard::ask(std::string question, std::function<void()> yes) {
  question_ = std::move(question);
  yes_ = std::move(yes);
  mode_ = Mode::kQuestion;
}

void Dashboard::ask_to_resume(bool all) {
  // What is asked about is what is told later, whatever is chosen by then.
  const std::string robot = shown_robot();
  if (robot.empty() || !may_steer(robot, all)) return;
  ask("Resume " + (all ? "all robots" : robot) + "?",
      [this, robot, all] { steering_.say(Operator::Word::kResume, robot, all); });
}

void Dashboard::ask_about_service() {
  const std::string robot = shown_robot();
  const Robot* known = model_.team().find(robot);
  if (!known || !known->state) return notices_.tell("No robot is heard that could be told.");
  const bool is_out = known->state->out_of_service;
  if (is_out && !may_steer(robot, false)) return;
  const auto word = is_out ? Operator::Word::kCommission : Operator::Word::kDecommission;
  ask(is_out ? "Commission " + robot + ", so that it serves again?"
             : "Decommission " + robot + ", so that it stands until it is commissioned?",
      [this, robot, word] { steering_.say(word, robot, false); });
}

void Dashboard::begin_text(Mode mode) {
  mode_ = mode;
  has_typed_ = false;
}

void Dashboard::open(std::unique_ptr<OpenSheet> sheet) {
  sheet_ = std::move(sheet);
  mode_ = Mode::kSheet;
}

bool Dashboard::tells_hindrance() {
  std::string why = pusher_.hindrance();
  if (why.empty() && shown_robot().empty()) why = "no robot is heard.";
  if (!why.empty()) notices_.tell("Cannot push: " + why);
  return !why.empty();
}

PushWish Dashboard::wish_for(bool to_all) {
  const Robot& robot = *model_.team().find(shown_robot());
  PushWish wish;
  if (!to_all) wish.robots = {robot.name};
  if (to_all && model_.team().robots().size() > 1) wish.canary = robot.name;
  if (!robot.program) return wish;
  wish.runs_hash = robot.program->hash;
  if (!to_all) wish.replaces = wish.runs_hash;
  for (const auto& file : robot.program->files) wish.runs.push_back({file.path, file.text});
  return wish;
}

void Dashboard::begin_push(bool last_good, bool to_all) {
  if (pusher_.report().stage == PushReport::Stage::kPushing)
    return open(std::make_unique<PushSheet>(pusher_));
  if (tells_hindrance()) return;
  wish_ = wish_for(to_all);
  if (!last_good) return begin_text(Mode::kFile);
  open(std::make_unique<PushSheet>(pusher_, std::move(wish_)));
}

void Dashboard::open_gains(bool to_all) {
  const std::string robot = shown_robot();
  if (robot.empty()) return notices_.tell("No robot is heard whose gains could be moved.");
  open(std::make_unique<GainSheet>(model_, pusher_, to_all ? "" : robot));
}

void Dashboard::open_history(bool to_all) {
  if (tells_hindrance()) return;
  open(std::make_unique<HistorySheet>(pusher_, wish_for(to_all)));
}

}  // namespace galilean::monitor::top
