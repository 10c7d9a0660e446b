// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/catalog/registry.h"
#include "core/clock.h"
#include "core/device/devices.h"
#include "core/result.h"
#include "robot/executive/breaks.h"
#include "robot/executive/fault_watch.h"
#include "robot/executive/guarded_drive.h"
#include "robot/executive/holding.h"
#include "robot/executive/odometry.h"
#include "robot/executive/program_intake.h"
#include "robot/executive/pushable_port.h"
#include "robot/executive/restore.h"
#include "robot/executive/running_program.h"
#include "robot/executive/standstill.h"
#include "robot/executive/state_hash.h"
#include "robot/executive/succession.h"
#include "robot/executive/tick_observer.h"

namespace galilean::robot {

/// The parts of an executive. All of them must outlive it.
struct ExecutiveSetup {
  const Registry& components;
  Devices devices;
  const Clock& clock;      ///< the only time that the logic uses
  const Clock& stopwatch;  ///< measures ticks; with a stepped clock that stands still they take no
                           ///< time
  std::uint64_t seed = 1;
  Duration tick_period = std::chrono::milliseconds(50);
  ProbationRules probation = {};
  DeviceTuner* tuner = nullptr;  ///< takes over the device settings of programs; may be null
  /// Whether the robot is held after a fault (see FaultWatch) until somebody lets it go on. Else it
  /// goes on by itself when the fault is over.
  bool holds_after_faults = false;
  std::vector<TickObserver*> observers = {};  ///< see every tick
  /// Is called by `load` and `roll_back`, in their thread, when a program or an order waits for the
  /// next tick. An early tick would bring it into effect sooner. May be null.
  std::function<void()> on_waiting = nullptr;
  /// Tells whether the robot can run a program, before `load` builds it. It is called in the thread
  /// of `load`. May be null: then the robot can run every program.
  std::function<Result<void>(const bhdl::Program&)> admits = nullptr;
};

/// The running program and its current state, which other threads read at once: aligned, every
/// compiler reads and writes both in one go.
struct alignas(8) Whereabouts {
  ProgramId program = 0;  ///< 0: none
  std::uint32_t state = 0;
};
static_assert(std::atomic<Whereabouts>::is_always_lock_free);

/// Runs a program: the paper's executive. The live robot calls `tick` from one thread at a fixed
/// rate; the headless simulator has many executives and calls it whenever it has stepped the clock.
///
///   tick:  exchange programs · sense · perceive · sequence · act · publish
///
/// In a tick the devices give what is newest, the state's perceptual schemas run in listed order,
/// the first condition in file order that holds and is not locked changes the state, and the motor
/// schemas of the state now current run in listed order. It neither allocates, locks, logs nor does
/// I/O. Each method says which thread may call it. "Control" is the thread that ticks. While
/// nothing ticks, any thread may call its methods.
class Executive {
 public:
  explicit Executive(const ExecutiveSetup& setup);
  ~Executive();
  Executive(const Executive&) = delete;
  Executive& operator=(const Executive&) = delete;

  /// Any thread but control, or between ticks. Builds `program` while the current one runs. It
  /// takes over at the start of the next tick. The first program starts in its start state. A later
  /// one is in probation, by the rules of the setup or by its own. Errors: another program still
  /// waits for its first tick; the robot cannot run the program; the program cannot be built.
  Result<ProgramId> load(bhdl::Program program) {
    return load(std::move(program), setup_.probation);
  }
  Result<ProgramId> load(bhdl::Program program, const ProbationRules& rules);

  /// Any thread but control. Orders that `program`, if it still runs in the next tick, is replaced
  /// by the program that ran before it. It need not be in probation. A predecessor that had not
  /// proven itself is in probation again. An event reports the rollback with the reason. Nothing
  /// happens if there is no program to go back to. Returns false if too many such orders wait.
  bool roll_back(ProgramId program, std::string_view reason);

  /// Any thread. Returns whether a loaded program waits for its first tick.
  [[nodiscard]] bool waiting() const noexcept { return intake_.waiting() || exchanging_.load(); }
  /// Any thread. Returns the running program's number, or 0 before the first tick with a program.
  [[nodiscard]] ProgramId running() const noexcept { return where_.load().program; }
  /// Any thread but control. Returns the current state's name, or an empty text before the first
  /// tick with a program.
  [[nodiscard]] std::string present_state() const;
  [[nodiscard]] const ProbationRules& probation_rules() const noexcept { return setup_.probation; }

  /// Control: runs one tick.
  void tick();

  /// Any thread. Returns the seed of all random numbers.
  [[nodiscard]] std::uint64_t seed() const noexcept { return setup_.seed; }

  /// Any thread: from the next tick on the schemas run and the motors stand still.
  void hold() noexcept { holding_.hold(); }
  void resume() noexcept { holding_.resume(); }
  /// Any thread: lets the robot go on until its next change of state, in whose tick the motors
  /// stand still again. Returns false, and changes nothing, if an operator or a fault holds it.
  [[nodiscard]] bool step() noexcept { return holding_.step(); }
  /// Any thread: holds the robot for a break point of another one. Returns false, and changes
  /// nothing, if it stands already.
  [[nodiscard]] bool stop_with_team() noexcept { return holding_.stop(Hold::kTeam); }
  /// Any thread: holds the robot after a fault that the devices do not show, until somebody lets it
  /// go on. One that stands already is left as it is.
  void hold_after(FaultCause cause) noexcept {
    noted_fault_.store(cause, std::memory_order_relaxed);
    static_cast<void>(holding_.stop(Hold::kFault));
  }
  [[nodiscard]] bool held() const noexcept { return !lets_drive(holding_.now()); }
  [[nodiscard]] bool held_after_fault() const noexcept { return holding_.now() == Hold::kFault; }
  /// Where the robot stops. Each method of Breaks says which thread may call it.
  [[nodiscard]] Breaks& breaks() noexcept { return breaks_; }
  /// Any thread: takes the robot out of service. The motors then stand still, and `resume` does not
  /// change that.
  void decommission() noexcept { in_service_.store(false, std::memory_order_relaxed); }
  void commission() noexcept { in_service_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool in_service() const noexcept {
    return in_service_.load(std::memory_order_relaxed);
  }
  /// Any thread: has the same effect as pushing bumper `index` (0 to 7) for 0.3 s.
  void push_bumper(int index) noexcept { port_.push(index); }
  /// Any thread but control: destroys programs that were replaced. `load` does so too.
  void collect() { intake_.collect(); }
  /// Any thread but control. Returns what the numbers in events and snapshots mean. Returns null
  /// for a program that no longer exists, if sixteen others came after it.
  [[nodiscard]] std::shared_ptr<const Description> description(ProgramId id) const {
    return intake_.description(id);
  }

  /// Control, between ticks: lets the running program continue from `situation`. Does nothing if no
  /// program runs. It allocates, and is for the simulator only.
  void restore(const Situation& situation);

  /// Control, between ticks or from an observer of a tick: writes all that the executive remembers
  /// at the end of the tick, but for the program's text, the table of break points, and programs to
  /// go back to. It neither allocates nor waits. Returns the number of words, or 0 if no program
  /// runs or `room` is too small.
  [[nodiscard]] std::size_t save(std::span<std::uint64_t> room) const noexcept;
  /// Control, between ticks: lets the program that waits go on from what another executive saved
  /// while that program ran. Returns false if it was saved of another program.
  [[nodiscard]] bool adopt(std::span<const std::uint64_t> saved) noexcept;
  [[nodiscard]] bool has_predecessor() const noexcept { return succession_.has_predecessor(); }

  /// Control, as for all methods below. Returns null before the first tick with a program.
  [[nodiscard]] const RunningProgram* program() const noexcept { return succession_.running(); }
  /// Returns an empty text before the first tick with a program.
  [[nodiscard]] std::string_view state_name() const noexcept;
  [[nodiscard]] Duration time_in_state() const noexcept;
  [[nodiscard]] Pose2 pose() const noexcept;  ///< by dead reckoning, odom frame
  [[nodiscard]] std::uint64_t transitions() const noexcept { return transitions_; }
  [[nodiscard]] const Tick& last_tick() const noexcept { return tick_; }
  /// Adds tick, state, pose and every variable to the hash, so that two runs can be compared. Of an
  /// image it adds the number of its frame.
  void hash_into(StateHash& hash) const noexcept;

 private:
  void keep(Memory& memory) noexcept;
  void begin_tick() noexcept;
  void watch_faults(Duration since_last_tick) noexcept;
  void take_orders() noexcept;
  void exchange_programs() noexcept;
  void install(const Handover& handover) noexcept;
  void go_on_from(const RunningProgram& replaced) noexcept;
  void sense() noexcept;
  void perceive() noexcept;
  void sequence() noexcept;
  void act() noexcept;
  void publish() noexcept;

  void enter(std::uint32_t state) noexcept;
  void activate(std::uint32_t schema) noexcept;
  void run(std::uint32_t schema) noexcept;
  void note_failure(std::uint32_t schema) noexcept;
  [[nodiscard]] std::optional<std::uint32_t> condition_that_fires() noexcept;
  [[nodiscard]] bool is_locked(std::uint32_t condition) const noexcept;
  void note_transition(Event change, std::string_view from_state) noexcept;
  void stop_at(Event& change, std::string_view from_state) noexcept;
  [[nodiscard]] Standstill standstill() const noexcept;
  void judge_probation() noexcept;
  [[nodiscard]] bool may_drive() const noexcept;
  [[nodiscard]] Event event(Event::Kind kind) const noexcept;
  void emit(const Event& event) noexcept;
  [[nodiscard]] RunningProgram* current_program() noexcept { return succession_.running(); }
  [[nodiscard]] const RunningState& current() const noexcept;

  const ExecutiveSetup setup_;
  PushablePort port_;
  GuardedDrive drive_;
  const Devices devices_;  ///< the devices as schemas see them: with the port and the drive above

  ProgramIntake intake_;
  Succession succession_;
  Event exchanged_;  ///< the exchange of programs in this tick, reported when the tick's time is
                     ///< known
  Odometry odometry_;
  DeviceHealth health_;

  Tick tick_;
  Time began_{};  ///< by the stopwatch
  Duration tick_time_{};
  std::uint32_t overruns_ = 0;
  std::uint64_t transitions_ = 0;
  bool state_changed_ = false;
  Breaks breaks_;
  Holding holding_;
  StandingOrders orders_;    ///< those of this tick
  Hold hold_ = Hold::kNone;  ///< what holds the robot in this tick
  Standstill standstill_;    ///< but for `hold`, which other threads change
  FaultWatch faults_;
  std::atomic<FaultCause> noted_fault_{FaultCause::kNone};
  std::atomic<bool> in_service_{true};
  std::atomic<Whereabouts> where_{};
  /// Whoever sees that no program waits also sees which one runs: a program that left the intake
  /// waits until `where_` is its place.
  std::atomic<bool> exchanging_{false};
};

}  // namespace galilean::robot
