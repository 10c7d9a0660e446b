// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>
#include <unistd.h>

#include <iostream>

#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/termination.h"
#include "monitor/access/operator_key.h"
#include "monitor/commands/push_options.h"
#include "monitor/orders/break_orders.h"
#include "monitor/top/dashboard.h"
#include "monitor/top/dashboard_feed.h"
#include "monitor/top/once.h"
#include "monitor/top/push/monitor_pusher.h"
#include "monitor/top/screen/job_control.h"
#include "monitor/top/screen/terminal.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;

struct Options {
  int domain = -1;
  bool once = false;
  bool ascii = false;
  bool no_mouse = false;
  std::string robot;
  std::string key_file;
  PushOptions push;
};

constexpr int kRedrawEach_ms = 100;
constexpr int kUnusable = 2;  ///< the exit code where there is no terminal to use

/// What ends the dashboard or changes its screen, besides keys.
struct Signals {
  Termination termination;
  top::JobControl jobs;
};

/// Gives the terminal back while the process is stopped or in the background.
void obey(top::JobControl& jobs, top::Terminal& terminal) {
  for (auto event = jobs.take(); event != top::JobControl::Event::kNone; event = jobs.take()) {
    terminal.leave();
    if (event == top::JobControl::Event::kStop) top::JobControl::stop();
  }
  // A shell need not signal that a process that runs comes to the foreground.
  if (!terminal.is_entered()) terminal.enter();
}

/// Waits for a key, a signal or the time of the next screen. Returns false if the terminal is gone.
bool wait(const Signals& signals, top::Terminal& terminal) {
  const short keys = terminal.is_entered() ? POLLIN : 0;  // in the background they are the shell's
  pollfd events[] = {{STDIN_FILENO, keys, 0},
                     {signals.termination.descriptor(), POLLIN, 0},
                     {signals.jobs.descriptor(), POLLIN, 0},
                     {terminal.output(), POLLOUT, 0}};
  // Messages do not wake this loop, because robots send them more often than the eye needs.
  ::poll(events, terminal.is_behind() ? 4 : 3, kRedrawEach_ms);
  if (events[0].revents & (POLLHUP | POLLERR | POLLNVAL)) return false;
  return !(events[0].revents & POLLIN) || terminal.read_keys();
}

/// Returns the way to the robots over DDS. Requires: what is passed outlives it.
top::Voice voice_of(Operator& speaker, BreakOrders& orders) {
  return {[&](Operator::Word word, const std::vector<std::string>& robots) {
            return speaker.say(word, robots) ? speaker.last_id() : std::string();
          },
          [&](const msg::BreakOrder& order) { return orders.give(order); }};
}

int run_dashboard(top::DashboardFeed& feed, Signals& signals, const Clock& clock,
                  const top::Voice& voice, const Options& options) {
  const top::Look look{top::colours_of(top::process_environment),
                       options.ascii || !top::is_utf8(top::process_environment)};
  top::MonitorPusher pusher(options.push);
  top::Dashboard dashboard({feed.model(), feed.history(), clock, voice, pusher}, options.robot);
  top::Terminal terminal(look, !options.no_mouse);
  while (!signals.termination.asked()) {
    dashboard.update();
    terminal.measure();
    terminal.show(dashboard.draw(terminal.columns(), terminal.rows()));
    feed.look_through(dashboard.drawn_robot());
    if (!wait(signals, terminal)) return 0;
    obey(signals.jobs, terminal);
    feed.poll();
    for (auto press = terminal.take_key(); press.key != top::Key::kNone;
         press = terminal.take_key())
      if (!dashboard.press(press)) return 0;
  }
  return 0;
}

int run(const Options& options) try {
  if (const auto usable = top::Terminal::check(top::process_environment); !usable && !options.once)
    return std::cerr << "galilean-top: " << usable.error().message << '\n', kUnusable;
  Signals signals;
  const SteadyClock clock;
  const auto participant = wire::Participant::join("top", options.domain);
  if (!participant) return std::cerr << "galilean-top: " << participant.error().message << '\n', 1;
  top::DashboardFeed feed(*participant.value(), clock);
  if (options.once) return top::print_once(feed, signals.termination, clock, options.robot);
  const auto signer = find_signer(options.key_file);
  if (!signer) return std::cerr << "galilean-top: " << signer.error().message << '\n', 1;
  Operator speaker(*participant.value(), signer.value());
  BreakOrders orders(*participant.value(), signer.value());
  return run_dashboard(feed, signals, clock, voice_of(speaker, orders), options);
} catch (const std::exception& error) {
  return std::cerr << "galilean-top: " << error.what() << '\n', 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CommandLine app(
      "Shows and steers the team in a terminal: each robot's state, pose and certainty, why it "
      "changed, and programs. Press ? for the keys.",
      "galilean top");
  add_domain_option(app, options.domain);
  app.flag("--once", options.once, "Print one snapshot as plain text, for scripts");
  app.flag("--ascii", options.ascii, "Draw ASCII alone, as where the locale is not UTF-8");
  app.flag("--no-mouse", options.no_mouse, "Leave the mouse to the terminal, which selects text");
  app.option("--robot", options.robot, "The robot to show first").not_empty();
  add_monitor_option(app, options.push);
  add_key_option(app, options.key_file);
  app.describe_exit(kUnusable, "The command line is wrong, or there is no terminal to use.");
  if (const auto code = app.parse(argc, argv)) return *code;
  return run(options);
}
