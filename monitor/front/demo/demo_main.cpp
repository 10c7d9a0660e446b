// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>

#include <iostream>
#include <sstream>

#include "core/broken_pipe.h"
#include "core/clock.h"
#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/exit_code.h"
#include "core/command_line/robots_option.h"
#include "core/termination.h"
#include "core/wake.h"
#include "monitor/front/demo/ensemble.h"
#include "monitor/front/demo/evidence.h"
#include "monitor/ingest/ingest.h"

namespace {

using namespace galilean;
using namespace galilean::front;

/// Writes a sentence to stderr with one line feed. A sentence that quotes a log may end in several.
void complain(std::string_view sentence) {
  while (sentence.ends_with('\n')) sentence.remove_suffix(1);
  std::cerr << "galilean-demo: " << sentence << '\n';
}

/// Reads the team's states and scores from DDS into an Evidence.
class Witness {
 public:
  Witness(wire::Participant& participant, Evidence& evidence)
      : ingest_(
            participant, {.message = [&evidence](const monitor::Message& m) { hear(m, evidence); }},
            [this] { wake_.ring(); }, is_wanted) {}

  [[nodiscard]] int descriptor() const noexcept { return wake_.descriptor(); }
  void poll() {
    wake_.clear();
    ingest_.poll();
  }

 private:
  static bool is_wanted(const monitor::Channel& channel) {
    const auto type = channel.schema->ros_type;
    return type == msg::RobotState::kRosType || type == msg::Score::kRosType;
  }
  template <class M>
  static void note(const monitor::Message& message, Evidence& evidence) {
    M decoded;
    if (msg::decode_cdr(*message.cdr, decoded)) evidence.note(decoded);
  }
  static void hear(const monitor::Message& message, Evidence& evidence) {
    if (message.channel.schema->ros_type == msg::Score::kRosType)
      note<msg::Score>(message, evidence);
    else
      note<msg::RobotState>(message, evidence);
  }

  Wake wake_;
  monitor::Ingest ingest_;
};

/// The result of a run.
struct Outcome {
  bool fatal_loss = false;
  std::vector<std::string> lost;
};

void report(const Ensemble::Loss& loss) {
  complain(loss.name + " ended (" + loss.ending + "); " +
           (loss.fatal ? "without it nothing works" : "the others go on") + ". See " +
           loss.log.string() + (loss.log_end.empty() ? "" : ":\n" + loss.log_end));
}

/// Runs until termination is asked for, `for_s` seconds are over, or a process ends without which
/// nothing works.
Outcome run_on(Ensemble& ensemble, Witness& witness, Termination& termination,
               std::optional<double> for_s) {
  constexpr int kLookEach_ms = 100;
  const SteadyClock clock;
  Outcome outcome;
  while (!termination.asked() && !(for_s && to_seconds(clock.now() - Time{}) >= *for_s)) {
    pollfd events[] = {{witness.descriptor(), POLLIN, 0}, {termination.descriptor(), POLLIN, 0}};
    poll(events, 2, kLookEach_ms);
    witness.poll();
    for (const auto& loss : ensemble.losses()) {
      report(loss);
      outcome.lost.push_back(loss.name);
      outcome.fatal_loss |= loss.fatal;
    }
    if (outcome.fatal_loss) break;
  }
  return outcome;
}

/// Prints the judgement of a headless run and returns its exit code.
int judge(const Evidence& evidence, const Outcome& outcome, bool interrupted) {
  std::cout << evidence.summary();
  auto reasons = evidence.shortcomings();
  for (const auto& name : outcome.lost) reasons.push_back(name + " ended");
  if (interrupted) reasons.push_back("interrupted before its time was over");
  for (const auto& reason : reasons) complain(reason);
  std::cout << (reasons.empty() ? "The team worked.\n" : "The team did not work.\n");
  return reasons.empty() ? 0 : 1;
}

/// Returns the exit code of a headless run: that of the team's work and that of its expectations.
int judge_all(Ensemble& ensemble, const Evidence& evidence, const Outcome& outcome,
              const DemoOptions& options, bool interrupted) {
  const int work = judge(evidence, outcome, interrupted);
  if (options.expectations.empty() || interrupted) return work;
  const auto expectations = ensemble.judge_recording();
  if (!expectations) return complain(expectations.error().message), kFailed;
  return work == kFailed ? kFailed : expectations.value();
}

/// Returns what is wrong with the options together; an empty text if nothing is.
std::string contradiction(const DemoOptions& options) {
  if (!options.expectations.empty() && !options.headless_for_s)
    return "--expect judges a run that ends: give --headless-for, too";
  if (!options.junit.empty() && options.expectations.empty()) return "--junit needs --expect";
  return {};
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

int run(const DemoOptions& options) try {
  ignore_broken_pipes();
  Termination termination;
  Ensemble ensemble(options, termination);
  if (const auto started = ensemble.start(); !started) {
    complain(started.error().message);
    return 1;
  }
  const auto participant = wire::Participant::join("demo", options.domain);
  if (!participant) {
    complain(participant.error().message);
    return 1;
  }
  std::cout << ensemble.operator_link() << "\n  " << list(ensemble.robots()) << " run "
            << options.bhdl << " in scenario " << options.scenario << "; logs in "
            << ensemble.logs().string() << "; Ctrl-C ends all" << std::endl;
  if (options.watch)
    std::cout << "  Save " << options.bhdl
              << " and the robots swap to it. Its errors are written to "
              << (ensemble.logs() / (ensemble.robots().front() + ".log")).string() << std::endl;
  Evidence evidence(ensemble.robots());
  Outcome outcome;
  {
    Witness witness(*participant.value(), evidence);
    outcome = run_on(ensemble, witness, termination, options.headless_for_s);
  }
  const bool interrupted = termination.asked();
  const auto problems = ensemble.end();
  for (const auto& problem : problems) complain(problem);
  if (outcome.fatal_loss || !problems.empty()) return std::cout << evidence.summary(), kFailed;
  if (options.headless_for_s) return judge_all(ensemble, evidence, outcome, options, interrupted);
  std::cout << '\n' << evidence.summary();  // behind the terminal's ^C
  return 0;
} catch (const std::exception& error) {
  complain(error.what());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  DemoOptions options;
  CommandLine app("Starts the simulator, robots and the monitor on this machine; Ctrl-C ends all.",
                  "galilean demo");
  add_robots_option(app, options.robots);
  app.option("--port", options.port, "Port of the page on 127.0.0.1")
      .between(1, 65535)
      .show_default();
  app.option("--scenario", options.scenario, "A scenario that ships, or a JSON file")
      .names_shipped_file("scenarios", ".json")
      .show_default();
  app.option("--bhdl", options.bhdl, "A program that ships, or a BHDL file")
      .names_shipped_file("programs", ".bhdl")
      .show_default();
  app.flag("--watch", options.watch, "Swap the robots' program whenever it is saved");
  app.option("--seed", options.seed, "Seed of the random number generators").show_default();
  app.option("--headless-for", options.headless_for_s,
             "End after this many seconds, with exit code 0 if the team worked")
      .positive();
  app.option("--record", options.record, "Record all topics to this file, as MCAP")
      .names_file(".mcap");
  app.option("--expect", options.expectations,
             "Judge the recording of a headless run by these expectations: files, or those that "
             "ship")
      .names_shipped_file("expectations", ".expect");
  app.option("--junit", options.junit, "Write what came of them as JUnit's XML to this file, too")
      .names_file(".xml");
  app.option("--allow-origin", options.allowed_origins,
             "Another page that may use the monitor, as https://host[:port]");
  add_domain_option(app, options.domain);
  app.describe_exit(kFailed, "The team did not work, or an expectation does not hold.");
  app.describe_exit(kIncomplete, "The team worked, and for some expectations it cannot be told.");
  if (const auto code = app.parse(argc, argv)) return *code;
  if (const auto sentence = contradiction(options); !sentence.empty()) return app.refuse(sentence);
  return run(options);
}
