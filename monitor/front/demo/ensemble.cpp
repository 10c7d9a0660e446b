// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/ensemble.h"

#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/command_line/exit_code.h"
#include "core/installation.h"
#include "core/json_text.h"
#include "core/private_file.h"
#include "monitor/access/operator_key.h"
#include "monitor/access/tokens.h"
#include "monitor/front/demo/namesakes.h"
#include "monitor/front/demo/program_check.h"
#include "monitor/front/demo/run_logs.h"
#include "monitor/front/siblings.h"

namespace galilean::front {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kStartsWithin_s = 30;  // and one more for each robot
constexpr auto kLookEach = std::chrono::milliseconds(10);
constexpr std::size_t kLogLines = 5;
constexpr const char* kRecorder = "record";
constexpr const char* kAutostart_s = "1";  // counted from the connection of the last robot

}  // namespace

Ensemble::Ensemble(const DemoOptions& options, Termination& termination)
    : options_(options),
      termination_(termination),
      logs_(new_run(".galilean", "run-" + std::to_string(getpid()))),
      check_(options.expectations, options.junit, logs_, termination),
      recorder_words_(logs_ / (std::string(kRecorder) + ".log")),
      run_("demo-" + std::to_string(getpid())) {
  if (!options_.expectations.empty() && options_.record.empty())
    options_.record = (logs_ / "run.mcap").string();
}

Ensemble::~Ensemble() {
  (void)end();
}

std::string Ensemble::operator_link() const {
  const auto token =
      monitor::read_token(monitor::operator_token_file(monitor::default_data_folder()));
  return "http://127.0.0.1:" + std::to_string(options_.port) +
         (token ? "/#token=" + token.value() : "");
}

Result<void> Ensemble::start() {
  forget_old_runs(logs_.parent_path(), kKeptRuns - 1);
  if (auto made = make_private_folder(logs_); !made) return made;
  if (!options_.expectations.empty()) {
    if (auto begun = check_.begin(); !begun) return begun;
    if (auto read = check_.read_expectations(); !read) return read;
  }
  if (auto checked = check_program(options_.bhdl); !checked) return checked;
  // The monitor signs with this key, and so do commands in other terminals of the same user.
  const auto key = monitor::open_operator_key(monitor::default_data_folder());
  if (!key) return key.error();
  if (auto started = start_simulator(); !started) return started;
  // After the first process was started, which would inherit what belongs to DDS.
  auto namesakes = Namesakes::look(options_.domain);
  if (!namesakes) return namesakes.error();
  auto ready = await_line("\"ready\"");
  if (!ready) return ready.error();
  if (auto named = name_robots(ready.value()); !named) return named;
  if (auto free = namesakes.value()->check(robot_names_, termination_); !free) return free;
  namesakes.value().reset();
  if (auto started = start_recorder(); !started) return started;
  if (auto started = start_robots(ready.value()); !started) return started;
  if (auto started = start_monitor(); !started) return started;
  return await_recording();  // last, since the others need longer
}

Result<void> Ensemble::add(std::string name, std::vector<std::string> command, bool fatal) {
  command[0] = sibling(command[0]);
  if (!is_program(command[0])) return Error{command[0] + " is not there; build it first"};
  if (options_.domain >= 0)
    command.insert(command.end(), {"--domain", std::to_string(options_.domain)});
  auto process = Process::start(name, command, logs_ / (name + ".log"));
  if (!process) return process.error();
  members_.push_back({std::move(process).value(), fatal});
  return {};
}

Result<void> Ensemble::start_simulator() {
  return add("sim",
             {"galilean-sim", "--live", "--scenario", options_.scenario, "--robots",
              std::to_string(options_.robots), "--seed", std::to_string(options_.seed), "--run",
              run_, "--autostart", kAutostart_s},
             true);
}

Result<void> Ensemble::name_robots(const std::string& ready_line) try {
  const auto ready = read_json(ready_line);
  if (!ready) return Error{"the simulator's ready line cannot be read: " + ready.error().message};
  for (const auto& robot : ready.value().at("robots"))
    robot_names_.push_back(robot.at("name").get<std::string>());
  return {};
} catch (const nlohmann::json::exception& error) {
  return Error{"the simulator's ready line cannot be read: " + std::string(error.what())};
}

Result<void> Ensemble::start_robots(const std::string& ready_line) try {
  const auto read = read_json(ready_line);
  if (!read) return Error{"the simulator's ready line cannot be read: " + read.error().message};
  const auto& ready = read.value();
  lines_ = ready.value("folder", std::string());
  const std::string program = find_file(options_.bhdl, "programs", ".bhdl").string();
  const std::string trusted =
      public_key_file(monitor::operator_key_file(monitor::default_data_folder())).string();
  std::uint64_t seed = options_.seed * 1000;
  for (const auto& robot : ready.at("robots")) {
    const auto name = robot.at("name").get<std::string>();
    const auto camera = robot.at("camera").get<std::string>();
    const auto& place = robot.at("start");
    starts_.push_back(name + ":" + json_text(place.at("x_m")) + "," + json_text(place.at("y_m")) +
                      "," + json_text(place.at("heading_deg")));
    rings_.push_back(camera.substr(camera.find(':') + 1));
    std::vector<std::string> command{"galilean-robot", "--name", name, "--bhdl", program,
                                     "--serial", robot.at("serial").get<std::string>(), "--camera",
                                     camera, "--seed", std::to_string(++seed),
                                     // Nobody attends a demo, whose simulator breaks parts, and
                                     // whose machine may be too busy to tick for a second.
                                     "--resume-by-itself",
                                     // A demo begins anew, also after one that was killed.
                                     "--keep-nothing", "--trust", trusted};
    if (options_.watch) command.push_back("--watch");
    if (auto added = add(name, std::move(command), false); !added) return added;
  }
  return {};
} catch (const nlohmann::json::exception& error) {
  return Error{"the simulator's ready line cannot be read: " + std::string(error.what())};
}

Result<void> Ensemble::start_monitor() {
  const std::string place = "127.0.0.1:" + std::to_string(options_.port);
  std::vector<std::string> command{"galilean-monitor", "--listen", place};
  for (const auto& start : starts_) command.insert(command.end(), {"--start", start});
  for (const auto& origin : options_.allowed_origins)
    command.insert(command.end(), {"--allow-origin", origin});
  if (auto added = add("monitor", command, true); !added) return added;
  const auto answered = await_line("http://");
  if (!answered) return answered.error();
  return {};
}

Result<void> Ensemble::start_recorder() {
  if (options_.record.empty()) return {};
  return add(kRecorder,
             {"galilean-record", "--out", options_.record, "--about",
              "seed=" + std::to_string(options_.seed), "scenario=" + options_.scenario,
              "bhdl=" + options_.bhdl, "robots=" + std::to_string(options_.robots)},
             false);
}

Result<void> Ensemble::await_recording() {
  for (auto& member : members_)
    if (member.process.name() == kRecorder)
      return await(member.process, [&] {
        std::error_code not_yet;
        return fs::exists(options_.record, not_yet);
      });
  return {};
}

Result<std::string> Ensemble::await_line(std::string_view mark) {
  Process& process = members_.back().process;
  std::string line;
  const auto ready = await(process, [&] {
    auto found = line_with(process.log(), mark);
    if (found) line = std::move(*found);
    return found.has_value();
  });
  if (!ready) return ready.error();
  return line;
}

Result<void> Ensemble::await(Process& process, const std::function<bool()>& is_ready) {
  const std::chrono::seconds most(kStartsWithin_s + options_.robots);
  const auto deadline = std::chrono::steady_clock::now() + most;
  while (std::chrono::steady_clock::now() < deadline) {
    const bool running = process.running();
    if (is_ready()) return {};
    if (termination_.asked()) return Error{"ended while starting"};
    if (!running)
      return Error{process.name() + " did not start (" + process.ending() + "):\n" +
                   last_lines(process.log(), kLogLines)};
    std::this_thread::sleep_for(kLookEach);
  }
  return Error{process.name() + " is not ready after " + std::to_string(most.count()) + " s; see " +
               process.log().string()};
}

std::vector<Ensemble::Loss> Ensemble::losses() {
  std::vector<Loss> lost;
  for (auto& member : members_) {
    if (member.lost || member.process.running()) continue;
    member.lost = true;
    lost.push_back({member.process.name(), member.process.ending(),
                    last_lines(member.process.log(), kLogLines), member.process.log(),
                    member.fatal});
  }
  return lost;
}

int Ensemble::recorder_exit_code() const {
  for (const auto& member : members_)
    if (member.process.name() == kRecorder) return member.process.exit_code().value_or(kFailed);
  return 0;
}

// The recorder ends first, while the others still send. The simulator ends last, because the robots
// stop their motors through it.
std::vector<std::string> Ensemble::end() {
  std::vector<std::string> problems;
  const auto end_those = [&](auto&& chosen) {
    for (auto& member : members_)
      if (chosen(member.process.name())) member.process.ask_to_end();
    for (auto& member : members_)
      if (chosen(member.process.name()) && !member.process.end())
        problems.push_back(member.process.name() + " would not end and was killed; see " +
                           member.process.log().string());
  };
  end_those([](const std::string& name) { return name == kRecorder; });
  end_those([](const std::string& name) { return name != "sim"; });
  end_those([](const std::string&) { return true; });
  sweep();
  return problems;
}

// A simulator that was killed leaves its cameras' shared memory and its serial lines behind.
void Ensemble::sweep() const {
  for (const auto& ring : rings_) shm_unlink(ring.c_str());
  std::error_code ignored;
  if (!lines_.empty() && lines_.filename() == "galilean-" + run_) fs::remove_all(lines_, ignored);
}

}  // namespace galilean::front
