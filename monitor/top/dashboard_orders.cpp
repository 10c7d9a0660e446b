// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "monitor/top/dashboard.h"
#include "monitor/top/sheets/push_sheet.h"

namespace galilean::monitor::top {

std::string Dashboard::shown_robot() const {
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
  if (robot.empty()) return;
  ask("Resume " + (all ? "all robots" : robot) + "?",
      [this, robot, all] { steering_.say(Operator::Word::kResume, robot, all); });
}

void Dashboard::ask_about_service() {
  const std::string robot = shown_robot();
  const Robot* known = model_.team().find(robot);
  if (!known || !known->state) return notices_.tell("No robot is heard that could be told.");
  const bool is_out = known->state->out_of_service;
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

void Dashboard::begin_push(bool last_good, bool to_all) {
  if (pusher_.report().stage == PushReport::Stage::kPushing)
    return open(std::make_unique<PushSheet>(pusher_));
  if (const auto why = pusher_.hindrance(); !why.empty())
    return notices_.tell("Cannot push: " + why);
  const Robot* robot = model_.team().find(shown_robot());
  if (!robot) return notices_.tell("Cannot push: no robot is heard.");
  wish_ = {};
  if (!to_all) wish_.robots = {robot->name};
  if (to_all && model_.team().robots().size() > 1) wish_.canary = robot->name;
  if (robot->program) {
    wish_.runs_hash = robot->program->hash;
    for (const auto& file : robot->program->files) wish_.runs.push_back({file.path, file.text});
  }
  if (!last_good) return begin_text(Mode::kFile);
  open(std::make_unique<PushSheet>(pusher_, std::move(wish_)));
}

}  // namespace galilean::monitor::top
