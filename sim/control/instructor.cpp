// SPDX-License-Identifier: BSD-3-Clause
#include "sim/control/instructor.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>
#include <utility>

#include "core/plural.h"
#include "sim/control/parts.h"
#include "sim/world/free_place.h"

namespace galilean::sim {
namespace {

constexpr double kLongestStep_s = 3600;
constexpr double kHardestPush_ns = 20;
/// Pushes add up. A body that is much faster passes through a wall between two steps.
constexpr double kFastestPushed_mps = 5;
constexpr std::size_t kMostPieces = 500;

std::string number_text(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", number);
  return text.data();
}

std::string place_text(const Vec2& at_m) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "(%.2f, %.2f) m", at_m.x(), at_m.y());
  return text.data();
}

/// Returns whether the number is in the range. No range has a number that is not finite.
bool is_between(double number, double least, double most) {
  return number >= least && number <= most;
}

/// Returns whether an angle is one that a 32-bit float holds without losing its direction.
bool is_heading(double heading_rad) {
  constexpr double kMost_rad = 1000;
  return is_between(heading_rad, -kMost_rad, kMost_rad);
}

std::optional<PieceKind> piece_kind(std::string_view name) {
  for (const PieceKind kind : {PieceKind::kCan, PieceKind::kCup, PieceKind::kWad})
    if (name == to_string(kind)) return kind;
  return std::nullopt;
}

Vec2 place_of(const msg::SimulationOrder& order) {
  return {order.x_m, order.y_m};
}

}  // namespace

Result<std::string> Instructor::carry_out(const msg::SimulationOrder& order) {
  using Handler = Answer (Instructor::*)(const Order&);
  static constexpr std::array<std::pair<std::string_view, Handler>, 13> kHandlers{
      {{"pause", &Instructor::pause},
       {"go_on", &Instructor::go_on},
       {"step", &Instructor::step},
       {"rate", &Instructor::set_rate},
       {"move", &Instructor::move},
       {"push", &Instructor::push},
       {"drop", &Instructor::drop},
       {"remove", &Instructor::remove},
       {"break", &Instructor::break_part},
       {"mend", &Instructor::mend},
       {"start_contest", &Instructor::start_contest},
       {"pause_contest", &Instructor::pause_contest},
       {"reset_contest", &Instructor::reset_contest}}};
  std::string known;
  for (const auto& [name, handler] : kHandlers) {
    if (order.order == name) return (this->*handler)(order);
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  return Error{"there is no order '" + order.order + "': expected one of " + known};
}

Instructor::Answer Instructor::pause(const Order&) {
  if (pace_.paused()) return Error{"the simulation is paused already"};
  pace_.pause();
  return std::string("paused the simulation");
}

Instructor::Answer Instructor::go_on(const Order&) {
  if (!pace_.paused()) return Error{"the simulation is not paused"};
  pace_.go_on();
  return std::string("let the simulation go on");
}

Instructor::Answer Instructor::step(const Order& order) {
  if (!is_between(order.duration_s, World::kStep_s, kLongestStep_s))
    return Error{"a step of " + number_text(order.duration_s) +
                 " s is out of range: expected 0.01 to 3600"};
  pace_.run_steps(static_cast<std::uint64_t>(std::llround(order.duration_s / World::kStep_s)));
  return "let the simulation go on for " + number_text(order.duration_s) + " s";
}

Instructor::Answer Instructor::set_rate(const Order& order) {
  if (!is_between(order.rate, Pace::kSlowest, Pace::kFastest))
    return Error{"a rate of " + number_text(order.rate) + " is out of range: expected 0.1 to 20"};
  pace_.set_rate(order.rate);
  return "set the rate to " + number_text(order.rate);
}

Instructor::Answer Instructor::move(const Order& order) {
  const auto found = body(order);
  if (!found) return found.error();
  if (const auto in_arena = inside(order); !in_arena) return in_arena.error();
  b2Body& moved = *found.value();
  if (order.turns && !is_heading(order.heading_rad)) return Error{"the heading is no angle"};
  const Pose2 pose{place_of(order), order.turns ? wrap_angle(order.heading_rad) : moved.GetAngle()};
  if (const auto there = occupant(world_.bodies(), moved, pose))
    return Error{order.subject + " cannot stand at " + place_text(pose.position_m) +
                 ": it would stand in " + world_.name_of(*there)};
  world_.place(moved, pose);
  return "moved " + order.subject + " to " + place_text(pose.position_m);
}

Instructor::Answer Instructor::push(const Order& order) {
  const auto found = robot(order);
  if (!found) return found.error();
  if (!(order.impulse_ns > 0 && order.impulse_ns <= kHardestPush_ns))
    return Error{"a push of " + number_text(order.impulse_ns) +
                 " Ns is out of range: expected more than 0, and at most 20"};
  if (!is_heading(order.heading_rad)) return Error{"the direction is no angle"};
  const Vec2 impulse_ns = unit_vector(order.heading_rad) * order.impulse_ns;
  const double speed_mps = found.value()->speed_after_mps(impulse_ns);
  if (speed_mps > kFastestPushed_mps)
    return Error{"with this push " + order.subject + " would go at " + number_text(speed_mps) +
                 " m/s: expected at most 5 m/s; wait until it is slower"};
  found.value()->push(impulse_ns);
  return "pushed " + order.subject + " with " + number_text(order.impulse_ns) + " Ns";
}

Instructor::Answer Instructor::drop(const Order& order) {
  const auto kind = piece_kind(order.subject);
  if (!kind)
    return Error{"there is no kind of piece '" + order.subject + "': expected can, cup or wad"};
  if (const auto in_arena = inside(order); !in_arena) return in_arena.error();
  if (world_.objects().pieces().size() >= kMostPieces)
    return Error{"this simulation has had 500 pieces already: reset the contest"};
  const Vec2 at_m = place_of(order);
  if (const auto there = occupant(world_.bodies(), at_m, shape_of(*kind).radius_m))
    return Error{"a " + order.subject + " cannot lie at " + place_text(at_m) +
                 ": it would lie in " + world_.name_of(*there)};
  return "dropped " + world_.drop({*kind, at_m}) + " at " + place_text(at_m);
}

Instructor::Answer Instructor::remove(const Order& order) {
  const auto found = body(order);
  if (!found) return found.error();
  const BodyTag tag = tag_of(*found.value());
  if (tag.kind != BodyKind::kPiece)
    return Error{order.subject + " cannot be removed: only cans, cups and wads can"};
  world_.remove_piece(tag.index);
  return "removed " + order.subject;
}

Instructor::Answer Instructor::break_part(const Order& order) {
  const auto found = robot(order);
  if (!found) return found.error();
  const auto done = sim::break_part(found.value()->broken(), order.part, order.fault);
  if (!done) return done.error();
  return "broke " + order.part + " of " + order.subject + ": it is " +
         (order.fault.empty() ? "dead" : order.fault);
}

Instructor::Answer Instructor::mend(const Order& order) {
  const auto found = robot(order);
  if (!found) return found.error();
  if (const auto done = mend_part(found.value()->broken(), order.part); !done)
    return Error{order.subject + ": " + done.error().message};
  return "mended " + order.part + " of " + order.subject;
}

Instructor::Answer Instructor::start_contest(const Order&) {
  switch (world_.referee().phase()) {
    case Phase::kWaiting:
      contest_.start();
      return std::string("started the contest");
    case Phase::kPaused:
      world_.referee().start();
      return std::string("let the contest go on");
    case Phase::kRunning:
      return Error{"the contest runs already"};
    case Phase::kOver:
      break;
  }
  return Error{"the contest is over: reset it first"};
}

Instructor::Answer Instructor::pause_contest(const Order&) {
  if (world_.referee().phase() != Phase::kRunning)
    return Error{std::string("the contest does not run: it is ") +
                 to_string(world_.referee().phase())};
  world_.referee().pause();
  return std::string("paused the contest");
}

Instructor::Answer Instructor::reset_contest(const Order&) {
  world_.reset();
  return std::string("reset the contest");
}

Result<b2Body*> Instructor::body(const Order& order) const {
  if (b2Body* found = world_.find_body(order.subject)) return found;
  return Error{"nothing here is called '" + order.subject +
               "': the simulation's state lists what there is"};
}

Result<RobotBody*> Instructor::robot(const Order& order) const {
  std::string names;
  for (std::size_t i = 0; i < world_.robot_count(); ++i) {
    if (robot_name(i) == order.subject) return &world_.robot(i);
    names += (names.empty() ? "" : ", ") + robot_name(i);
  }
  return Error{"there is no robot '" + order.subject + "': " +
               agreeing(world_.robot_count(), "the only robot is ", "the robots are ") + names};
}

Result<void> Instructor::inside(const Order& order) const {
  const ArenaRules& arena = world_.scenario().arena;
  if (is_between(order.x_m, 0, arena.width_m) && is_between(order.y_m, 0, arena.depth_m)) return {};
  return Error{place_text(place_of(order)) +
               " is outside of the arena, which reaches from (0, 0) to " +
               place_text({arena.width_m, arena.depth_m})};
}

}  // namespace galilean::sim
