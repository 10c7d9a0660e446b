// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rerun/rerun.h"

#include <utility>

#include "bhdl/check.h"
#include "core/plural.h"
#include "robot/inputs/input_digests.h"
#include "robot/inputs/picture_packing.h"

namespace galilean::robot {
namespace {

/// Returns the first of the program's errors, if it has any.
Result<bhdl::Program> program_of(const msg::GivenProgram& given, const Catalog& catalog) {
  std::vector<bhdl::SourceFile> files;
  for (const auto& file : given.files) files.push_back({file.path, file.text});
  if (files.empty()) return Error{"its text is not recorded"};
  auto checked = bhdl::check(std::move(files), catalog);
  if (checked.program) return std::move(*checked.program);
  for (const auto& diagnostic : checked.diagnostics)
    if (diagnostic.severity == bhdl::Severity::kError) return Error{format(diagnostic)};
  return Error{"it has errors"};
}

}  // namespace

Rerun::Rerun(const Registry& components, std::optional<bhdl::Program> other)
    : components_(components), other_program_(std::move(other)) {}

void Rerun::take(const msg::TickInputs& inputs) {
  if (over() || (last_tick_ != 0 && inputs.tick <= last_tick_)) return;
  result_.robot = inputs.robot;
  result_.cannot_tell = gap_before(inputs);
  if (over()) return;
  result_.cannot_tell = damage(inputs);
  if (over()) return;
  if (const auto done = run(inputs); !done) {
    result_.cannot_tell = done.error().message;
    return;
  }
  if (last_tick_ == 0) first_ns_ = inputs.now_ns;
  last_tick_ = inputs.tick;
  ++result_.ticks;
  result_.recorded_s = to_seconds(Duration(inputs.now_ns - first_ns_));
  compare_tick(inputs);
}

std::string Rerun::gap_before(const msg::TickInputs& inputs) const {
  if (inputs.tick == last_tick_ + 1) return "";
  if (last_tick_ == 0)
    return "the recording begins with tick " + std::to_string(inputs.tick) +
           " of the run, and what the robot had in mind then is not recorded: start galilean "
           "record before the robot, or at most ten seconds after it";
  return "the inputs of " + plural(inputs.tick - last_tick_ - 1, "tick") + " are missing" +
         (inputs.lost > 0 ? ", which the robot could not hand over" : "");
}

/// Finds inputs that are not those which the robot read.
std::string Rerun::damage(const msg::TickInputs& inputs) {
  const auto is_not = [](const std::string& what) {
    return what + " of this tick is not what the robot read, because its digest differs";
  };
  if (inputs.orders_digest != orders_digest(inputs))
    return is_not("something of the clock, orders, break points and program");
  if (inputs.board_digest != board_digest(inputs)) return is_not("the board's status");
  if (!inputs.picture.empty()) {
    rgb_.resize(Frame::kBytes);
    if (!unpack(inputs.picture, rgb_)) return "the picture of this tick, which is damaged";
    pixels_digest_ = pixels_digest(rgb_);
  }
  if (inputs.picture_digest != picture_digest(inputs, pixels_digest_)) return is_not("the picture");
  return "";
}

Result<void> Rerun::run(const msg::TickInputs& inputs) {
  if (!recorded_) {
    recorded_ = std::make_unique<RecordedRobot>(components_, inputs);
    if (other_program_) other_ = std::make_unique<RecordedRobot>(components_, inputs);
  }
  for (const auto& given : inputs.program)
    if (auto loaded = load(given); !loaded) return loaded;
  const std::span<const std::uint8_t> new_picture =
      inputs.picture.empty() ? std::span<const std::uint8_t>() : rgb_;
  if (auto done = recorded_->tick(inputs, new_picture); !done) return done;
  return other_ ? other_->tick(inputs, new_picture) : Result<void>();
}

Result<void> Rerun::load(const msg::GivenProgram& given) {
  auto program = program_of(given, components_.catalog());
  const auto refused = [&](const Error& error) {
    return Error{"program " + given.hash.substr(0, 8) + " cannot run here: " + error.message};
  };
  if (!program) return refused(program.error());
  if (other_) {
    auto loaded =
        other_->load(std::exchange(other_program_, std::nullopt).value_or(program.value()), given);
    if (!loaded) return loaded;
  }
  if (auto loaded = recorded_->load(std::move(program).value(), given); !loaded)
    return refused(loaded.error());
  return {};
}

void Rerun::compare_tick(const msg::TickInputs& inputs) {
  result_.divergence = compare(inputs.outcome, *recorded_);
  if (result_.divergence && other_) {
    result_.cannot_tell = "here the recorded program itself leads to something else: " +
                          std::exchange(result_.divergence, std::nullopt)->cause;
    return;
  }
  if (other_) result_.divergence = compare(*recorded_, *other_);
  if (!result_.divergence) return;
  result_.divergence->tick = inputs.tick;
  result_.divergence->at_s = to_seconds(Duration(inputs.now_ns));
}

}  // namespace galilean::robot
