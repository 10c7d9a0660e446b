// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/identity.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace galilean::monitor::top {
namespace {

/// The paper's robots.
constexpr std::array kReserved{"io", "ganymede", "callisto"};

std::string letters_of(const std::string& name) {
  std::string letters;
  for (const unsigned char c : name)
    if (std::isalnum(c)) letters += static_cast<char>(std::toupper(c));
  return letters;
}

std::string digits_at_end(const std::string& name) {
  const auto last = name.find_last_not_of("0123456789");
  return last == name.npos ? name : name.substr(last + 1);
}

std::string letter_of(const std::string& name, const std::vector<Identity>& others) {
  const auto is_free = [&](const std::string& letter) {
    return std::ranges::find(others, letter, &Identity::letter) == others.end();
  };
  const std::string letters = letters_of(name), digits = digits_at_end(name);
  const std::string first = letters.empty() ? "R" : letters.substr(0, 1);
  if (!digits.empty() && is_free(first + digits)) return first + digits;
  for (const char letter : digits.empty() ? letters : std::string())
    if (is_free({letter})) return {letter};
  auto number = others.size() + 1;
  while (!is_free(first + std::to_string(number))) ++number;  // others were forgotten
  return first + std::to_string(number);
}

}  // namespace

Identity identity_of(const std::string& name, const std::vector<Identity>& others) {
  const auto reserved = std::ranges::find(kReserved, name);
  auto number = static_cast<std::size_t>(reserved - kReserved.begin());
  const auto is_taken = [&] {
    return std::ranges::find(others, number, &Identity::number) != others.end();
  };
  while (number >= kReserved.size() && is_taken()) ++number;
  return {number, letter_of(name, others)};
}

void Identities::meet(const std::string& robot) {
  if (by_name_.contains(robot)) return;
  std::vector<Identity> others;
  for (const auto& [name, identity] : by_name_) others.push_back(identity);
  by_name_[robot] = identity_of(robot, others);
}

const Identity& Identities::of(const std::string& robot) const {
  static const Identity kUnknown{};
  const auto found = by_name_.find(robot);
  return found == by_name_.end() ? kUnknown : found->second;
}

}  // namespace galilean::monitor::top
