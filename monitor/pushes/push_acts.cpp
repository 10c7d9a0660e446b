// SPDX-License-Identifier: BSD-3-Clause
// What a transaction asks its desk to do.
#include <boost/asio/post.hpp>
#include <iostream>
#include <utility>

#include "core/json_text.h"
#include "core/wire/ros_time.h"
#include "monitor/pushes/json.h"
#include "monitor/pushes/push_desk.h"
#include "monitor/pushes/push_words.h"

namespace galilean::monitor {

void PushDesk::act(const OpenPtr& open, SwapTransaction::Act act) {
  using Act = SwapTransaction::Act;
  switch (act) {
    case Act::kCheck:
      return check(open);
    case Act::kTry:
      return try_out(open);
    case Act::kEndTrial:
      return open->trial.reset();
    case Act::kPushCanary:
      return push_canary(open);
    case Act::kPushRest:
      return push_rest(open);
    case Act::kTakeBack:
      return take_back(open);
  }
}

void PushDesk::check(const OpenPtr& open) {
  parts_.worker.run(
      [open, &library = parts_.library] {
        return check_for(open->order.files, open->targets.awaited, library);
      },
      [this, open](TargetCheck checked) { take_check(open, std::move(checked)); },
      [this, open](const std::string& why) { give_up(open, why + "; nothing was pushed"); });
}

void PushDesk::take_check(const OpenPtr& open, TargetCheck check) {
  if (!check.result.program) {
    std::erase(open_, open);
    return open->answer(broken(check));
  }
  open->message = make_push(*check.result.program, open->order.author, open->order.targets,
                            replaced_by_each(open->order, open->targets, parts_.team));
  open->message.id = open->record.id;
  if (open->order.probation) {
    // A canary stays on probation for as long as it may be taken back.
    const Duration more = open->order.canary.empty() ? Duration() : SwapTransaction::kPatience;
    open->message.probation_s = static_cast<float>(to_seconds(*open->order.probation + more));
  }
  open->message.stamp = wire::ros_time(open->record.pushed_ns);
  open->record.hash = open->message.hash;
  open->record.program = open->message.files.front().path;
  if (!open->swap.over()) write_down(open);
}

/// Before anything of it is sent: what reached a robot is never missing from the history.
void PushDesk::write_down(const OpenPtr& open) {
  parts_.worker.run(
      [this, message = open->message, progress = open->newest().progress] {
        parts_.history.add(message, progress);
        return true;
      },
      [this, open](bool) {
        open->swap.checked({}, parts_.clock.now());
        const bool takes_long = open->order.trial.wanted || !open->order.canary.empty();
        if (takes_long) open->answer({202, to_json(open->newest())});
        go_on(open);
      },
      [this, open](const std::string& why) { give_up(open, why + "; nothing was pushed"); });
}

void PushDesk::try_out(const OpenPtr& open) {
  std::vector<bhdl::SourceFile> files;
  for (const auto& file : open->message.files) files.push_back({file.path, file.text});
  auto trial =
      parts_.trials.begin(open->record.id, open->order, files, open->targets,
                          [this, weak = std::weak_ptr(open)](const Result<TrialFigures>& result) {
                            if (const auto still = weak.lock()) take_trial(still, result);
                          });
  if (!trial) return open->swap.tried(trial.error().message, {}, parts_.clock.now());
  open->trial = std::move(trial).value();
}

void PushDesk::take_trial(const OpenPtr& open, const Result<TrialFigures>& result) {
  std::string objection, finding;
  if (!result) {
    objection = result.error().message;
  } else {
    const auto& figures = result.value();
    open->record.progress.trial_json = json_text(to_json(figures));
    finding = in_words(figures);
    const bool decides = !open->order.trial.only && !open->order.trial.even_if_worse;
    if (decides && clearly_worse(figures)) objection = "in simulation it " + finding;
  }
  open->swap.tried(objection, finding, parts_.clock.now());
  // Not from within its own last word.
  boost::asio::post(parts_.io, [over = std::shared_ptr<Trial>(std::move(open->trial))] {});
  go_on(open);
}

void PushDesk::push_canary(const OpenPtr& open) {
  send(open, {open->order.canary});
}

void PushDesk::push_rest(const OpenPtr& open) {
  if (open->order.targets.empty()) parts_.team.note_push(open->message.hash);
  // The canary runs it already. Without one the team is meant as it is, with robots that are not
  // heard here.
  send(open, open->order.canary.empty() ? open->order.targets : open->swap.rest());
}

/// The robot has kept the program that it ran before, and says what became of the order.
void PushDesk::take_back(const OpenPtr& open) {
  msg::ProgramRollback order;
  order.stamp = wire::ros_time(wire::wall_clock_ns());
  order.id = open->take_back_id = new_id();
  order.author = open->order.author;
  order.targets = {open->order.canary};
  order.hash = open->message.hash;
  order.reason = open->swap.steps()[SwapTransaction::kCanaryStep].detail;
  const auto warn = [robot = open->order.canary] {
    std::clog << "galilean-monitor: DDS did not take the order to " << robot
              << " to go back; push what it is to run\n";
  };
  parts_.worker.run([this, order] { return rollbacks_.write(order); },
                    [warn](bool taken) {
                      if (!taken) warn();
                    },
                    [warn](const std::string&) { warn(); });
}

void PushDesk::send(const OpenPtr& open, const std::vector<std::string>& targets) {
  auto message = open->message;
  message.targets = targets;
  parts_.worker.run([this, message = std::move(message)] { return pushes_.write(message); },
                    [this, open](bool taken) {
                      if (!taken) give_up(open, "DDS did not take the program; try again");
                    },
                    [this, open](const std::string& why) { give_up(open, why); });
}

}  // namespace galilean::monitor
