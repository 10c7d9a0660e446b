// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>

#include <iostream>
#include <sstream>

#include "core/broken_pipe.h"
#include "core/clock.h"
#include "core/command_line/exit_code.h"
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

/// Prints the judgement of a headless run. Returns why the team did not work; nothing if it did.
std::vector<std::string> judge(const Evidence& evidence, const Outcome& outcome, bool interrupted) {
  std::cout << evidence.summary();
  auto reasons = evidence.shortcomings();
  for (const auto& name : outcome.lost) reasons.push_back(name + " ended");
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
              const DemoOptions& options, bool interrupted) {
  const auto problems = judge(evidence, outcome, interrupted);
  if (options.expectations.empty()) return problems.empty() ? 0 : kFailed;
  if (interrupted) return give_up(ensemble, kInterrupted);
  const auto expectations = ensemble.judge_recording(problems);
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
  auto problems = ensemble.end();
  for (const auto& problem : problems) complain(problem);
  if (outcome.fatal_loss || !problems.empty()) {
    std::cout << evidence.summary();
    for (const auto& name : outcome.lost) problems.push_back(name + " ended");
    return give_up(ensemble, list(problems));
  }
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
  if (const auto code = read_options(argc, argv, options)) return *code;
  return run(options);
}
