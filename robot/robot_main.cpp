// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cerrno>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "bhdl/check.h"
#include "core/broken_pipe.h"
#include "core/last_sentence.h"
#include "core/secure_folder.h"
#include "core/state_folder.h"
#include "core/termination.h"
#include "core/wire/refusals.h"
#include "robot/components.h"
#include "robot/control_loop.h"
#include "robot/devices/frame_sources.h"
#include "robot/devices/pump_thread.h"
#include "robot/devices/serial_port.h"
#include "robot/executive/opened_devices.h"
#include "robot/executive/snapshot.h"
#include "robot/log/log.h"
#include "robot/options.h"
#include "robot/restart/order_keeper.h"
#include "robot/restart/program_keeper.h"
#include "robot/restart/start.h"
#include "robot/robot_devices.h"
#include "robot/telemetry/namesake_watch.h"
#include "robot/telemetry/telemetry.h"
#include "robot/watch/program_watch.h"

namespace galilean::robot {
namespace {

constexpr Duration kLinePause = std::chrono::milliseconds(2);
constexpr Duration kCameraPause = std::chrono::milliseconds(5);
/// How long a last stop needs to get through the line.
constexpr Duration kStopFlushTime = std::chrono::milliseconds(100);

void wait_for(const Termination& termination) {
  pollfd signal{termination.descriptor(), POLLIN, 0};
  while (poll(&signal, 1, -1) < 0 && errno == EINTR) {
  }
}

void set_up_log(const Options& options) {
  spdlog::set_default_logger(spdlog::stderr_color_mt(options.name));
  spdlog::set_pattern("%H:%M:%S.%e %^%l%$ %n: %v");
  spdlog::set_level(spdlog::level::from_str(options.log_level));
}

/// Returns nothing if the program has errors. Each diagnostic is printed.
std::optional<bhdl::Program> read_program(const std::string& file, const Catalog& catalog) {
  auto checked = bhdl::check_file(file, catalog);
  for (const auto& diagnostic : checked.diagnostics) std::cerr << format(diagnostic) << "\n";
  return std::move(checked.program);
}

/// Where a signature proves who sent a program, the sender's name proves nothing more.
AcceptedSenders accepted_senders(const Options& options) {
  if (!options.accept_swaps_from.empty()) return AcceptedSenders(options.accept_swaps_from);
  return options.trust_file.empty() ? AcceptedSenders() : AcceptedSenders({AcceptedSenders::kAny});
}

/// Returns nothing if no file is named. Errors: it cannot be read, or names no key.
Result<std::optional<TrustedKeys>> trusted_keys(const Options& options) {
  if (options.trust_file.empty()) return std::optional<TrustedKeys>();
  auto keys = TrustedKeys::load(options.trust_file);
  if (!keys) return keys.error();
  return std::optional<TrustedKeys>(std::move(keys).value());
}

/// Says so where anybody may move the robot. With DDS Security the roles of members say who may.
void warn_without_keys(const Options& options) {
  const char* secured = std::getenv(kSecureVariable);
  if (!options.trust_file.empty() || (secured && *secured)) return;
  log_warning(
      "whoever is in this DDS domain can move this robot: name those who may with --trust FILE "
      "(docs/SECURITY.md)");
}

OpenedDevices opened_devices(const Options& options, const DeviceSettings& settings) {
  OpenedDevices opened{.baud = settings.comm_port.baud};
  if (!options.serial) opened.serial = settings.comm_port.device;
  if (!options.camera) opened.camera = settings.frame_grabber.device;
  return opened;
}

/// Errors: the program names other devices than those that are open.
Result<void> admit(const bhdl::Program& next, const OpenedDevices& opened, const Catalog& catalog) {
  auto accepted = opened.accept(next, catalog);
  const std::string overruled = accepted ? opened.overruled(next, catalog) : "";
  if (!overruled.empty()) log_warning(overruled);
  return accepted;
}

/// A second robot of a name ends before it has told or moved anything. Whoever starts it, by hand
/// or by a service, reads why at once. If it stayed, even held, the page would show two robots as
/// one that jumps, and one push, or one order to go on, would reach both.
Result<void> expect_no_namesake(wire::Participant& participant, const std::string& robot,
                                Termination& termination) {
  const SteadyClock clock;
  NamesakeWatch others(participant, robot);
  return others.expect_none(clock, [&] { return termination.asked(); });
}

/// Returns what the robot begins with, and logs why where there was a choice.
Start choose(const Options& options, bhdl::Program given, const Catalog& catalog,
             const std::filesystem::path& kept) {
  if (options.keeps_nothing) return {.program = std::move(given)};
  Start start =
      choose_start(std::move(given), read_kept_program(kept, options.name), catalog, options.fresh);
  if (!start.sentence.empty()) log_warning(start.sentence);
  return start;
}

/// Returns how far orders had come when the robot program ended, or says that nobody knows.
OrderNumbers numbers_before(const std::filesystem::path& kept) {
  auto numbers = read_order_numbers(kept);
  if (numbers) return std::move(numbers).value();
  log_warning(numbers.error().message +
              "; if the clock was set back meanwhile, orders of before could be sent again");
  return {};
}

/// Requires: the keeper outlives what is returned.
OrderMemory memory_with(OrderKeeper& keeper) {
  return {.before = numbers_before(keeper.file()),
          .keep = [&keeper](const OrderNumbers& numbers) { keeper.keep(numbers); }};
}

/// Whoever started the robot program again, or what did, may not see the robot. What operators had
/// ordered before it died holds in any case: a robot that goes on by itself after faults does not
/// go on after a stop.
void stand_still(const Start& start, bool resumes_by_itself, Executive& executive) {
  if (start.orders.out_of_service) executive.decommission();
  if (!start.orders.held_by.empty()) return executive.hold();
  if (resumes_by_itself) return;
  if (start.last_end == LastEnd::kDied) executive.hold_after(FaultCause::kRestart);
  if (start.last_end == LastEnd::kUnknown) executive.hold_after(FaultCause::kUnknownEnd);
}

int refuse(const std::string& reason) {
  std::cerr << "galilean-robot: " << reason << "\n";
  return 1;
}

/// What ran before a crash may need what is gone since, so that the robot would end at each start.
int refuse_start(const std::string& reason, bool is_given) {
  static_cast<void>(refuse(reason));
  return is_given ? 1 : refuse("begin with --fresh to run the program of --bhdl instead");
}

/// Runs the robot until a signal comes. Threads end in the reverse order of their start.
int work(const Options& options, const Registry& components, bhdl::Program given,
         Termination& termination) {
  const auto trust = trusted_keys(options);
  if (!trust) return refuse(trust.error().message);
  warn_without_keys(options);
  const auto participant = wire::Participant::join(options.name, options.domain);
  if (!participant) return refuse(participant.error().message);
  participant.value()->refusals().tell_with(
      [](const std::string& sentence) { log_warning(sentence); });
  if (const auto alone = expect_no_namesake(*participant.value(), options.name, termination);
      !alone)
    return refuse(alone.error().message);
  if (termination.asked()) return 0;

  ProgramKeeper keeper(
      kept_program_file(state_folder(), options.name, participant.value()->domain()), options.name);
  const DeviceSettings given_settings = DeviceSettings::of(given, components.catalog());
  const std::string given_hash = given.hash;
  const bool keeps_orders = trust.value() && !options.keeps_nothing;
  OrderKeeper order_keeper(
      order_numbers_file(state_folder(), options.name, participant.value()->domain()));
  Start start = choose(options, std::move(given), components.catalog(), keeper.file());
  const std::string pushed_hash = start.pushed ? start.program.hash : "";
  const bool is_given = start.program.hash == given_hash;
  const DeviceSettings settings =
      settings_to_open(start.program, given_settings, components.catalog());
  SerialPort line(options.serial.value_or(settings.comm_port.device), settings.comm_port.baud);
  const auto camera = make_frame_source(options.camera.value_or(settings.frame_grabber.device));
  const OpenedDevices opened = opened_devices(options, settings);
  if (!camera) return refuse_start(camera.error().message, is_given);

  const SteadyClock clock;
  RobotDevices devices(line, *camera.value(), settings, from_seconds(1 / options.rate_hz));
  SnapshotTap tap;
  ImageTap images(components.catalog());
  InputsTap inputs;
  Wake wake;
  Executive executive(
      {.components = components,
       .devices = devices.devices(),
       .clock = clock,
       .stopwatch = clock,
       .seed = options.seed,
       .tick_period = from_seconds(1 / options.rate_hz),
       .probation = {.length = from_seconds(options.probation_s),
                     .most_transitions_per_s = options.most_transitions_per_s},
       .tuner = &devices,
       .holds_after_faults = !options.resumes_by_itself,
       .observers = {&tap, &images, &inputs},
       .on_waiting = [&wake] { wake.ring(); },
       .admits =
           [&](const bhdl::Program& next) { return admit(next, opened, components.catalog()); }});
  const auto loaded = executive.load(std::move(start.program));
  if (!loaded) return refuse_start(loaded.error().message, is_given);
  stand_still(start, options.resumes_by_itself, executive);

  const PumpThread line_pump(
      clock, kLinePause, [&](Time now) { devices.pump_line(now); },
      [&](const std::string& why) { devices.fail_line(why); });
  const PumpThread camera_pump(
      clock, kCameraPause, [&](Time now) { devices.pump_camera(now); },
      [&](const std::string& why) { devices.fail_camera(why); });
  Telemetry telemetry(
      {.robot = options.name,
       .participant = *participant.value(),
       .executive = executive,
       .tap = tap,
       .devices = devices.devices(),
       .catalog = components.catalog(),
       .clock = clock,
       .accepted_senders = accepted_senders(options),
       .keep = [&](const bhdl::Program& proven,
                   bool pushed) { keeper.keep(proven, pushed || proven.hash == pushed_hash); },
       .trust = trust.value(),
       .held_by = start.orders.held_by,
       .keep_orders =
           [&](const std::string& held_by, bool out_of_service) {
             keeper.keep_orders({held_by, out_of_service});
           },
       .order_memory = keeps_orders ? memory_with(order_keeper) : OrderMemory{}},
      images, inputs);
  const auto tell_kept = [&](const std::string& problem) {
    telemetry.problems().note("restart", problem);
  };
  if (!options.keeps_nothing)
    tell_kept(
        keeper.begin(executive.description(loaded.value())->program, start.pushed, start.orders));
  {
    const Worker writing = options.keeps_nothing ? Worker() : keeper.writer(tell_kept);
    const auto tell_numbers = [&](const std::string& problem) {
      telemetry.problems().note("order_numbers", problem);
    };
    const Worker writing_numbers = keeps_orders ? order_keeper.writer(tell_numbers) : Worker();
    // The watch is made before the loop: if it cannot be made, nothing has moved yet.
    std::optional<ProgramWatch> watch;
    if (!options.watched_file.empty())
      watch.emplace(
          options.watched_file, components.catalog(), executive,
          [&](const std::string& problem) { telemetry.problems().note("watch", problem); });
    const ControlLoop loop(from_seconds(1 / options.rate_hz), wake, [&] { executive.tick(); });
    wait_for(termination);
  }
  devices.devices().motor_drive.stop();
  std::this_thread::sleep_for(kStopFlushTime);
  if (const std::string problem = options.keeps_nothing ? "" : keeper.end(); !problem.empty())
    log_warning(problem);
  if (const std::string problem = order_keeper.end(); !problem.empty()) log_warning(problem);
  log_info("the robot has stopped");
  return 0;
}

int run(int argc, const char* const* argv) {
  const auto parsed = parse_options(argc, argv);
  if (!parsed.options) return parsed.exit_code;
  const Options& options = *parsed.options;
  Registry components;
  add_components(components);
  if (options.print_catalog) {
    std::cout << catalog_to_json(components.catalog()) << "\n";
    return std::cout.flush() ? 0 : 1;
  }
  ignore_broken_pipes();
  set_up_log(options);
  auto program = read_program(options.bhdl_file, components.catalog());
  if (!program) return 1;
  Termination termination;
  return work(options, components, std::move(*program), termination);
}

}  // namespace
}  // namespace galilean::robot

int main(int argc, char** argv) {
  galilean::say_why_it_ends("galilean-robot");
  try {
    return galilean::robot::run(argc, argv);
  } catch (const std::exception& problem) {
    std::cerr << "galilean-robot: " << problem.what() << "\n";
    return 1;
  }
}
