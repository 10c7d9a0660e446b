// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/catalog/registry.h"
#include "core/device/device_names.h"
#include "core/device/devices.h"
#include "core/device/motor_drive.h"

namespace galilean::robot {

/// What the scripted schemas of the running test did, in order.
inline std::vector<std::string> journal;
/// Every `call` schema calls it. The test that uses such a schema sets it.
inline std::function<void(const Tick&)> on_call;

/// Notes in the journal that it was activated, and each run.
template <class Base>
class Note : public Base {
 public:
  static void describe(Declaration<Note>& is) {
    is.help("Notes that it ran.");
    is.text(&Note::word_, "word", "note", "what it notes");
  }
  void activate(const Tick&) override { journal.push_back("+" + word_); }
  void run(const Tick&) override { journal.push_back(word_); }

 private:
  std::string word_;
};

/// Makes bits valid and counts its runs in them.
class CountBits final : public PerceptualSchema {
 public:
  static void describe(Declaration<CountBits>& is) {
    is.help("Counts its runs in bits.");
    is.updates(&CountBits::bits_, "bits_variable", "the count");
  }
  void run(const Tick& tick) override {
    bits_->write({bits_->value.value + 1}, 1, tick.now, tick.number);
  }

 private:
  Variable<Bits>* bits_ = nullptr;
};

/// Writes the tick's number into a locate and a force.
class WriteAll final : public PerceptualSchema {
 public:
  static void describe(Declaration<WriteAll>& is) {
    is.help("Writes the tick's number into what it is given.");
    is.writes(&WriteAll::locate_, "locate_variable", "x: the tick").optional();
    is.writes(&WriteAll::force_, "force_variable", "x: the tick").optional();
    is.number(&WriteAll::certainty_, "certainty", unit::kNone, 1, "of what it writes").range(0, 1);
  }
  void run(const Tick& tick) override {
    const Vec2 content(static_cast<double>(tick.number), 0);
    if (locate_) {
      locate_->value.position_m = content;
      locate_->mark_written(certainty_, tick.now, tick.number);
    }
    if (force_) force_->write({content}, certainty_, tick.now, tick.number);
  }

 private:
  Variable<Locate>* locate_ = nullptr;
  Variable<Force>* force_ = nullptr;
  double certainty_ = 1;
};

/// Throws once `after` runs went well.
class Thrower final : public PerceptualSchema {
 public:
  static void describe(Declaration<Thrower>& is) {
    is.help("Throws.");
    is.number(&Thrower::runs_left_, "after", unit::kNone, 0, "runs that go well before")
        .range(0, 1000);
    is.writes(&Thrower::output_, "bits_variable", "what becomes invalid").optional();
  }
  void run(const Tick& tick) override {
    if (runs_left_-- <= 0) throw std::runtime_error("the lens broke");
    if (output_) output_->write({1}, 1, tick.now, tick.number);
  }
  void keep(Memory& memory) noexcept override { memory.keep(runs_left_); }

 private:
  int runs_left_ = 0;
  Variable<Bits>* output_ = nullptr;
};

/// Drives ahead at a constant speed.
class Ahead final : public MotorSchema {
 public:
  static void describe(Declaration<Ahead>& is) {
    is.help("Drives ahead.");
    is.number(&Ahead::speed_mps_, "speed", unit::kMetrePerSecond, 0.1, "forward").range(-1, 1);
    is.needs(kMotorDriveName);
    is.uses_devices(&Ahead::devices_);
  }
  void run(const Tick&) override { devices_->motor_drive.drive({.speed_mps = speed_mps_}); }

 private:
  double speed_mps_ = 0;
  const Devices* devices_ = nullptr;
};

/// Calls what the test has set.
class Call final : public MotorSchema {
 public:
  static void describe(Declaration<Call>& is) { is.help("Does what the test says."); }
  void run(const Tick& tick) override { on_call(tick); }
};

inline void add_scripted_schemas(Registry& registry) {
  registry.add_schema<Note<PerceptualSchema>>("note");
  registry.add_schema<Note<MotorSchema>>("note_motor");
  registry.add_schema<CountBits>("count_bits");
  registry.add_schema<WriteAll>("write_all");
  registry.add_schema<Thrower>("thrower");
  registry.add_schema<Ahead>("ahead");
  registry.add_schema<Call>("call");
}

}  // namespace galilean::robot
