// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "bhdl/check.h"
#include "robot/components.h"
#include "robot/executive/executive.h"
#include "tests/robot/executive/scripted_devices.h"
#include "tests/robot/executive/scripted_schemas.h"

namespace galilean::robot {

/// Keeps every event in its order.
class EventList final : public TickObserver {
 public:
  EventList() { events.reserve(1000); }
  void on_event(const Event& event) noexcept override { events.push_back(event); }
  void on_tick(const TickView& view) noexcept override {
    in_probation = view.in_probation;
    standstill = view.standstill;
    fault = view.fault;
  }

  [[nodiscard]] int count(Event::Kind kind) const {
    return static_cast<int>(std::ranges::count(events, kind, &Event::kind));
  }
  [[nodiscard]] const Event* last(Event::Kind kind) const {
    const Event* found = nullptr;
    for (const Event& event : events)
      if (event.kind == kind) found = &event;
    return found;
  }

  std::vector<Event> events;
  bool in_probation = false;
  Standstill standstill;  ///< of the last tick
  FaultReport fault;      ///< of the last tick
};

inline const Registry& test_components() {
  static const Registry registry = [] {
    Registry made;
    add_components(made);
    add_scripted_schemas(made);
    return made;
  }();
  return registry;
}

/// Returns the program that a text says. The test fails if the text has errors.
inline bhdl::Program program_of(const std::string& text,
                                const Registry& components = test_components()) {
  auto checked = bhdl::check({{"test.bhdl", text}}, components.catalog());
  for (const auto& diagnostic : checked.diagnostics)
    if (diagnostic.severity == bhdl::Severity::kError) ADD_FAILURE() << format(diagnostic) << text;
  return checked.program.value();
}

/// An executive on scripted devices and a stepped clock, with 20 ticks a second of that clock.
class TestRobot {
 public:
  explicit TestRobot(std::uint64_t seed = 1, std::vector<TickObserver*> more = {},
                     const ProbationRules& probation = {},
                     const Registry& own_components = test_components(),
                     bool holds_after_faults = false)
      : components(own_components) {
    more.push_back(&events);
    executive = std::make_unique<Executive>(
        ExecutiveSetup{.components = components,
                       .devices = {port, drive, camera},
                       .clock = clock,
                       .stopwatch = stopwatch,
                       .seed = seed,
                       .probation = probation,
                       .holds_after_faults = holds_after_faults,
                       .observers = std::move(more),
                       .on_waiting = [this] { on_waiting(); },
                       .admits = [this](const auto& program) { return admits(program); }});
    journal.clear();
  }

  Result<ProgramId> load(const std::string& text) {
    return executive->load(program_of(text, components));
  }
  void tick(int times = 1) {
    for (int i = 0; i < times; ++i) {
      clock.advance(std::chrono::milliseconds(50));
      executive->tick();
    }
  }
  void press(unsigned bumper, bool pressed = true) {
    const auto bit = static_cast<std::uint8_t>(1U << bumper);
    port.next.bumpers =
        static_cast<std::uint8_t>(pressed ? port.next.bumpers | bit : port.next.bumpers & ~bit);
  }
  [[nodiscard]] std::string state() const { return std::string(executive->state_name()); }
  /// Returns the variable. The test fails if the running program has no such variable.
  template <class T>
  [[nodiscard]] const Variable<T>& variable(std::string_view name) const {
    for (const auto& each : executive->program()->variables.all<T>())
      if (each.name == name) return each;
    ADD_FAILURE() << "no variable " << name;
    static const Variable<T> none;
    return none;
  }
  [[nodiscard]] Time now() const { return clock.now(); }

  const Registry& components;
  SteppedClock clock;
  SteppedClock stopwatch;
  ScriptedPort port;
  ScriptedDrive drive;
  ScriptedCamera camera;
  EventList events;
  std::function<void()> on_waiting = [] {};
  std::function<Result<void>(const bhdl::Program&)> admits = [](const auto&) {
    return Result<void>();
  };
  std::unique_ptr<Executive> executive;
};

}  // namespace galilean::robot
