// SPDX-License-Identifier: BSD-3-Clause
#include "sim/control/parts.h"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace galilean::sim {
namespace {

constexpr int kBumpers = 8;
constexpr const char* kDead = "dead";
constexpr const char* kStuck = "stuck";

constexpr std::array<std::pair<const char*, bool BrokenParts::*>, 5> kWholeParts{
    {{"camera", &BrokenParts::camera},
     {"serial_line", &BrokenParts::serial_line},
     {"board", &BrokenParts::board},
     {"left_wheel", &BrokenParts::left_wheel},
     {"right_wheel", &BrokenParts::right_wheel}}};

std::string bumper_name(int bumper) {
  return "bumper_" + std::to_string(bumper);
}

/// Returns the bit of a bumper, or nothing if `part` is no bumper.
std::optional<std::uint8_t> bumper_bit(const std::string& part) {
  for (int bumper = 0; bumper < kBumpers; ++bumper)
    if (part == bumper_name(bumper)) return static_cast<std::uint8_t>(1 << bumper);
  return std::nullopt;
}

bool BrokenParts::*whole_part(const std::string& part) {
  for (const auto& [name, member] : kWholeParts)
    if (part == name) return member;
  return nullptr;
}

Error unknown_part(const std::string& part) {
  return {
      "there is no part '" + part +
      "': expected camera, serial_line, board, left_wheel, right_wheel, or bumper_0 to bumper_7"};
}

void set(std::uint8_t& bits, std::uint8_t bit, bool on) {
  bits = static_cast<std::uint8_t>(on ? bits | bit : bits & ~bit);
}

}  // namespace

Result<void> break_part(BrokenParts& broken, const std::string& part, const std::string& fault) {
  const auto bumper = bumper_bit(part);
  const auto whole = whole_part(part);
  if (!bumper && !whole) return unknown_part(part);
  const bool dead = fault.empty() || fault == kDead;
  const bool stuck = fault == kStuck;
  if (!dead && !stuck) return Error{"there is no fault '" + fault + "': expected dead or stuck"};
  if (whole && stuck) return Error{"a " + part + " cannot be stuck; it can be dead"};
  if (whole) broken.*whole = true;
  if (bumper) {
    set(broken.dead_bumpers, *bumper, dead);
    set(broken.stuck_bumpers, *bumper, stuck);
  }
  return {};
}

Result<void> mend_part(BrokenParts& broken, const std::string& part) {
  const BrokenParts before = broken;
  const auto bumper = bumper_bit(part);
  const auto whole = whole_part(part);
  if (!bumper && !whole) return unknown_part(part);
  if (whole) broken.*whole = false;
  if (bumper) {
    set(broken.dead_bumpers, *bumper, false);
    set(broken.stuck_bumpers, *bumper, false);
  }
  if (broken == before) return Error{"its " + part + " is not broken"};
  return {};
}

std::vector<PartFault> faults_of(const BrokenParts& broken) {
  std::vector<PartFault> faults;
  for (const auto& [name, member] : kWholeParts)
    if (broken.*member) faults.push_back({name, kDead});
  for (int bumper = 0; bumper < kBumpers; ++bumper) {
    if (broken.dead_bumpers >> bumper & 1) faults.push_back({bumper_name(bumper), kDead});
    if (broken.stuck_bumpers >> bumper & 1) faults.push_back({bumper_name(bumper), kStuck});
  }
  return faults;
}

}  // namespace galilean::sim
