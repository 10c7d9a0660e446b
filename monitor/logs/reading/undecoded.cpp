// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/reading/undecoded.h"

#include <iostream>

#include "core/command_line/exit_code.h"
#include "core/plural.h"
#include "core/visible_text.h"

namespace galilean::logs {
namespace {

/// Of more topics and reasons than so many, the rest is counted together.
constexpr std::size_t kMostReasons = 100;

}  // namespace

void Undecoded::add(const std::string& topic, const std::string& reason) {
  const std::pair key(topic, reason);
  const auto known = counts_.find(key);
  if (known != counts_.end())
    ++known->second;
  else if (counts_.size() < kMostReasons)
    counts_[key] = 1;
  else
    ++counts_[{"other topics", "of other reasons"}];
}

int Undecoded::finish() const {
  for (const auto& [key, count] : counts_)
    std::cerr << program_ << ": " << plural(count, "message") << " of " << visible(key.first)
              << " could not be decoded: " << key.second << '\n';
  return counts_.empty() ? 0 : kIncomplete;
}

}  // namespace galilean::logs
