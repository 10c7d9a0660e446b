// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "core/broken_pipe.h"
#include "core/clock.h"
#include "core/command_line/exit_code.h"
#include "core/plural.h"
#include "core/termination.h"
#include "core/wake.h"
#include "monitor/front/demo/ensemble.h"
#include "monitor/front/demo/evidence.h"
#include "monitor/ingest/ingest.h"

namespace {

using namespace galilean;
using namespace galilean::front;

constexpr const char* kInterrupted = "interrupted before its time was over";

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
  bool no_robots = false;  ///< all of them have ended
  std::vector<std::string> lost;
  std::vector<std::string> shortages;  ///< why the recording is not whole
};

/// Returns whether every robot has ended.
bool are_all_lost(const std::vector<std::string>& robots, const Outcome& outcome) {
  return std::ranges::all_of(robots, [&](const auto& robot) {
    return std::ranges::find(outcome.lost, robot) != outcome.lost.end();
  });
}

/// Repeats what the recorder says, as soon as it says it: nobody reads its log before the end.
void repeat_recorder(Ensemble& ensemble, Outcome& outcome) {
  for (const auto& sentence : ensemble.recorder_said()) {
    complain(sentence);
    if (tells_of_full_disk(sentence)) outcome.shortages.push_back(sentence);
  }
}

/// Says how the recorder ended, if not well. Returns its exit code.
int end_of_recorder(Ensemble& ensemble, Outcome& outcome) {
  const int code = ensemble.recorder_exit_code();
  if (code == kIncomplete)
    complain("messages are missing in " + ensemble.recording() + "; 'galilean log info " +
             ensemble.recording() + "' shows which");
  else if (code != 0)
    repeat_recorder(ensemble, outcome);
  return code;
}

void report(const Ensemble::Loss& loss, const Outcome& outcome) {
  const char* so = loss.fatal          ? "without it nothing works"
                   : outcome.no_robots ? "no robot is left, so that the demo ends"
                                       : "the others go on";
  complain(loss.name + " ended (" + loss.ending + "); " + so + ". See " + loss.log.string() +
           (loss.log_end.empty() ? "" : ":\n" + loss.log_end));
}

/// Runs until termination is asked for, `for_s` seconds are over, a process ends without which
/// nothing works, or all robots have ended.
Outcome run_on(Ensemble& ensemble, Witness& witness, Termination& termination,
               std::optional<double> for_s) {
  constexpr int kLookEach_ms = 100;
  const SteadyClock clock;
  Outcome outcome;
  while (!termination.asked() && !(for_s && to_seconds(clock.now() - Time{}) >= *for_s)) {
    pollfd events[] = {{witness.descriptor(), POLLIN, 0}, {termination.descriptor(), POLLIN, 0}};
    poll(events, 2, kLookEach_ms);
    witness.poll();
    repeat_recorder(ensemble, outcome);
    for (const auto& loss : ensemble.losses()) {
      outcome.lost.push_back(loss.name);
      outcome.fatal_loss |= loss.fatal;
      outcome.no_robots = are_all_lost(ensemble.robots(), outcome);
      report(loss, outcome);
    }
    if (outcome.fatal_loss || outcome.no_robots) break;
  }
  return outcome;
}

/// Prints the judgement of a headless run. Returns why the team did not work; nothing if it did.
std::vector<std::string> judge(const Evidence& evidence, const Outcome& outcome, int recorder_code,
                               bool interrupted) {
  std::cout << evidence.summary();
  auto reasons = evidence.shortcomings();
  for (const auto& name : outcome.lost) reasons.push_back(name + " ended");
  if (recorder_code == kFailed && outcome.lost.empty())
    reasons.push_back("the recording could not be written to its end");
  if (interrupted) reasons.push_back(kInterrupted);
  for (const auto& reason : reasons) complain(reason);
  std::cout << (reasons.empty() ? "The team worked.\n" : "The team did not work.\n");
  return reasons;
}

/// Writes to JUnit's XML, where it is asked for, why nothing was judged. Returns the exit code.
int give_up(Ensemble& ensemble, const std::string& why) {
  if (const auto done = ensemble.give_up(why); !done && done.error().message != why)
    complain(done.error().message);
  return kFailed;
}

/// Returns the exit code of a headless run: that of the team's work and that of its expectations.
int judge_all(Ensemble& ensemble, const Evidence& evidence, const Outcome& outcome,
              const DemoOptions& options, int recorder_code, bool interrupted) {
  const auto problems = judge(evidence, outcome, recorder_code, interrupted);
  if (options.expectations.empty()) return problems.empty() ? recorder_code : kFailed;
  if (interrupted) return give_up(ensemble, kInterrupted);
  const auto expectations = ensemble.judge_recording(problems, outcome.shortages);
  if (!expectations) {
    complain(expectations.error().message);
    return give_up(ensemble, expectations.error().message);
  }
  return problems.empty() ? expectations.value() : kFailed;
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

int run(const DemoOptions& options) try {
  ignore_broken_pipes();
  ignore_file_size_limit();
  Termination termination;
  Ensemble ensemble(options, termination);
  if (const auto started = ensemble.start(); !started) {
    complain(started.error().message);
    return give_up(ensemble, started.error().message);
  }
  const auto participant = wire::Participant::join("demo", options.domain);
  if (!participant) {
    complain(participant.error().message);
    return give_up(ensemble, participant.error().message);
  }
  std::cout << ensemble.operator_link() << "\n  " << list(ensemble.robots())
            << agreeing(ensemble.robots().size(), " runs ", " run ") << options.bhdl
            << " in scenario " << options.scenario << "; logs in " << ensemble.logs().string()
            << "; Ctrl-C ends all" << std::endl;
  if (options.watch)
    std::cout << "  Save " << options.bhdl << " and "
              << agreeing(ensemble.robots().size(), "the robot swaps", "the robots swap")
              << " to it. Its errors are written to "
              << (ensemble.logs() / (ensemble.robots().front() + ".log")).string() << std::endl;
  Evidence evidence(ensemble.robots());
  Outcome outcome;
  {
    Witness witness(*participant.value(), evidence);
    outcome = run_on(ensemble, witness, termination, options.headless_for_s);
  }
  const bool interrupted = termination.asked();
  auto problems = ensemble.end();
  for (const auto& problem : problems) complain(problem);
  const int recorder_code = end_of_recorder(ensemble, outcome);
  if (outcome.fatal_loss || !problems.empty()) {
    std::cout << evidence.summary();
    for (const auto& name : outcome.lost) problems.push_back(name + " ended");
    return give_up(ensemble, list(problems));
  }
  if (options.headless_for_s)
    return judge_all(ensemble, evidence, outcome, options, recorder_code, interrupted);
  if (interrupted) std::cout << '\n';  // behind the terminal's ^C
  std::cout << evidence.summary();
  return outcome.no_robots && !interrupted ? kFailed : recorder_code;
} catch (const std::exception& error) {
  complain(error.what());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  DemoOptions options;
  if (const auto code = read_options(argc, argv, options)) return *code;
  return run(options);
}
