// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rerun/rerun.h"

#include <utility>

#include "bhdl/check.h"
#include "core/plural.h"
#include "robot/inputs/input_digests.h"
#include "robot/inputs/picture_packing.h"

namespace galilean::robot {
namespace {

/// More than that no executive remembers.
constexpr std::uint32_t kMostWords = 1U << 20;

/// Errors: the first of the program's, if it has any.
Result<bhdl::Program> program_given(const msg::GivenProgram& given, const Catalog& catalog) {
  const auto refused = [&](const std::string& why) {
    return Error{"program " + given.hash.substr(0, 8) + " cannot run here: " + why};
  };
  std::vector<bhdl::SourceFile> files;
  for (const auto& file : given.files) files.push_back({file.path, file.text});
  if (files.empty()) return refused("its text is not recorded");
  auto checked = bhdl::check(std::move(files), catalog);
  if (checked.program) return std::move(*checked.program);
  for (const auto& diagnostic : checked.diagnostics)
    if (diagnostic.severity == bhdl::Severity::kError) return refused(format(diagnostic));
  return refused("it has errors");
}

/// Errors: the words are damaged.
Result<std::vector<std::uint64_t>> words_of(const msg::ExecutiveMemory& memory) {
  std::vector<std::uint64_t> words(std::min(memory.words, kMostWords));
  const std::span<std::uint8_t> bytes{reinterpret_cast<std::uint8_t*>(words.data()),
                                      words.size() * sizeof(std::uint64_t)};
  if (!unpack_bytes(memory.packed, bytes) || memory_digest(memory, words) != memory.digest)
    return Error{"what the executive remembered is damaged"};
  return words;
}

std::string is_not_what_was_read(const std::string& what) {
  return what + " of this tick is not what the robot read, because its digest differs";
}

}  // namespace

Rerun::Rerun(const Registry& components, std::optional<bhdl::Program> other)
    : components_(components), other_program_(std::move(other)) {}

void Rerun::take(const msg::TickInputs& inputs) {
  if (result_.divergence || (last_tick_ != 0 && inputs.tick <= last_tick_)) return;
  result_.robot = inputs.robot;
  if (seen_first_ == 0) seen_first_ = inputs.tick;
  if (recorded_ && inputs.tick != last_tick_ + 1)
    lose(inputs, "the inputs of " + plural(inputs.tick - last_tick_ - 1, "tick") + " are missing" +
                     (inputs.lost > 0 ? ", which the robot could not hand over" : ""));
  const std::uint64_t compared = result_.ticks;
  if (recorded_)
    go_on(inputs);
  else
    begin(inputs);
  if (result_.ticks == compared) ++result_.left_out;
  last_tick_ = inputs.tick;
  last_ns_ = inputs.now_ns;
}

RerunResult Rerun::result() const {
  RerunResult result = result_;
  if (result.ticks > 0 || !result.cannot_tell.empty()) return result;
  result.cannot_tell =
      seen_first_ == 0
          ? "no tick is recorded"
          : "the recording begins with tick " + std::to_string(seen_first_) +
                " of the run, and what the executive remembered then is not recorded, or nothing "
                "after it is: record for longer, or start galilean record before the robot";
  return result;
}

/// Without the memory of an executive only the first tick of a run can be its beginning.
void Rerun::begin(const msg::TickInputs& inputs) {
  if (inputs.tick != 1 && inputs.memory.empty()) return;
  if (const auto why = damage(inputs); !why.empty()) return lose(inputs, why);
  if (auto done = inputs.tick == 1 ? start(inputs) : adopt(inputs); !done)
    return lose(inputs, done.error().message);
  if (inputs.tick == 1) compare_tick(inputs);
}

void Rerun::go_on(const msg::TickInputs& inputs) {
  if (const auto why = damage(inputs); !why.empty()) return lose(inputs, why);
  if (const auto done = run(inputs); !done) return lose(inputs, done.error().message);
  if (went_back(inputs))
    return lose(inputs, "the robot went back to a program that ran before the recording began");
  compare_tick(inputs);
}

void Rerun::lose(const msg::TickInputs& inputs, const std::string& why) {
  if (result_.cannot_tell.empty()) {
    result_.cannot_tell = why;
    result_.untold_tick = recorded_ ? last_tick_ + 1 : inputs.tick;
  }
  recorded_.reset();
  other_.reset();
}

/// Finds inputs that are not those which the robot read.
std::string Rerun::damage(const msg::TickInputs& inputs) {
  if (inputs.orders_digest != orders_digest(inputs))
    return is_not_what_was_read("something of the clock, orders, break points and program");
  if (inputs.board_digest != board_digest(inputs))
    return is_not_what_was_read("the board's status");
  if (!inputs.picture.empty()) {
    rgb_.resize(Frame::kBytes);
    if (!unpack(inputs.picture, rgb_)) return "the picture of this tick is damaged";
    pixels_digest_ = pixels_digest(rgb_);
  }
  if (inputs.picture_digest != picture_digest(inputs, pixels_digest_))
    return is_not_what_was_read("the picture");
  return "";
}

Result<void> Rerun::start(const msg::TickInputs& inputs) {
  lacks_predecessor_ = false;
  replaces_ = other_program_;
  recorded_ = std::make_unique<RecordedRobot>(components_, inputs);
  if (other_program_) other_ = std::make_unique<RecordedRobot>(components_, inputs);
  return run(inputs);
}

/// Another program takes over from the recorded one, as if it had been pushed then.
Result<void> Rerun::adopt(const msg::TickInputs& inputs) {
  const auto& memory = inputs.memory.front();
  const auto words = words_of(memory);
  if (!words) return words.error();
  auto program = program_given(memory.program, components_.catalog());
  if (!program) return program.error();
  if (other_program_) {
    other_ = std::make_unique<RecordedRobot>(components_, inputs);
    if (auto done = other_->adopt(program.value(), inputs, rgb_, words.value()); !done) return done;
    if (auto done = other_->load(*other_program_, memory.program); !done) return done;
  }
  lacks_predecessor_ = memory.has_predecessor;
  replaces_.reset();
  recorded_ = std::make_unique<RecordedRobot>(components_, inputs);
  return recorded_->adopt(std::move(program).value(), inputs, rgb_, words.value());
}

Result<void> Rerun::run(const msg::TickInputs& inputs) {
  for (const auto& given : inputs.program)
    if (auto loaded = load(given); !loaded) return loaded;
  const std::span<const std::uint8_t> new_picture =
      inputs.picture.empty() ? std::span<const std::uint8_t>() : rgb_;
  if (auto done = recorded_->tick(inputs, new_picture); !done) return done;
  return other_ ? other_->tick(inputs, new_picture) : Result<void>();
}

Result<void> Rerun::load(const msg::GivenProgram& given) {
  auto program = program_given(given, components_.catalog());
  if (!program) return program.error();
  if (other_) {
    auto taken = std::exchange(replaces_, std::nullopt).value_or(program.value());
    if (auto loaded = other_->load(std::move(taken), given); !loaded) return loaded;
  }
  return recorded_->load(std::move(program).value(), given);
}

/// Programs that ran before the memory was taken are not in it.
bool Rerun::went_back(const msg::TickInputs& inputs) const {
  return lacks_predecessor_ && inputs.program.empty() &&
         inputs.outcome.program != recorded_->outcome().program;
}

void Rerun::compare_tick(const msg::TickInputs& inputs) {
  if (result_.ticks == 0) result_.first_tick = inputs.tick;
  if (result_.ticks > 0 && last_tick_ + 1 == inputs.tick)
    result_.recorded_s += to_seconds(Duration(inputs.now_ns - last_ns_));
  ++result_.ticks;
  auto found = compare(inputs.outcome, *recorded_);
  if (found && other_)
    return lose(inputs,
                "here the recorded program itself leads to something else: " + found->cause);
  if (!found && other_) found = compare(*recorded_, *other_);
  if (!found) return;
  found->tick = inputs.tick;
  found->at_s = to_seconds(Duration(inputs.now_ns));
  result_.divergence = std::move(found);
}

}  // namespace galilean::robot
