// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/gains/tuner.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace galilean::monitor::top {

void Tuner::show(const msg::Program& program, const msg::Catalog& catalog) {
  if (program.hash == program_hash_ && catalog.hash == catalog_hash_) return;
  auto read = catalog_from_json(catalog.json);
  catalog_ = read ? std::move(read).value() : Catalog{};
  program_hash_ = program.hash;
  catalog_hash_ = catalog.hash;
  files_.clear();
  for (const auto& file : program.files) files_.push_back({file.path, file.text});
  tunables_ = tunables_in(files_, catalog_);
  std::erase_if(moved_, [&](const auto& moved) {
    const auto found = std::ranges::find(tunables_, moved.first, &Tunable::key);
    return found == tunables_.end() || exact_text(found->value) == moved.second;
  });
}

std::string Tuner::text_of(const Tunable& tunable) const {
  const auto moved = moved_.find(tunable.key);
  return moved == moved_.end() ? exact_text(tunable.value) : moved->second;
}

double Tuner::value_of(const Tunable& tunable) const {
  const auto moved = moved_.find(tunable.key);
  return moved == moved_.end() ? tunable.value : std::strtod(moved->second.c_str(), nullptr);
}

void Tuner::move(const Tunable& tunable, int steps) {
  const double whole = std::round(value_of(tunable) / tunable.step) + steps;
  const double value = std::clamp(whole * tunable.step, tunable.min, tunable.max);
  const std::string text = number_text(value, tunable.step);
  if (text == exact_text(tunable.value))
    moved_.erase(tunable.key);
  else
    moved_[tunable.key] = text;
}

std::vector<bhdl::SourceFile> Tuner::moved_files() const {
  return with_numbers(files_, catalog_, moved_);
}

std::string Tuner::reason() const {
  std::string reason;
  for (const auto& tunable : tunables_)
    if (is_moved(tunable))
      reason += (reason.empty() ? "" : ", ") + tunable.schema + " · " + tunable.label + " " +
                exact_text(tunable.value) + " → " + text_of(tunable);
  return reason;
}

void Tuner::note_sent() {
  undo_.clear();
  for (const auto& tunable : tunables_)
    if (is_moved(tunable)) undo_[tunable.key] = exact_text(tunable.value);
}

void Tuner::undo() {
  moved_.clear();
  for (const auto& tunable : tunables_)
    if (const auto before = undo_.find(tunable.key);
        before != undo_.end() && before->second != exact_text(tunable.value))
      moved_.insert(*before);
  undo_.clear();
}

}  // namespace galilean::monitor::top
