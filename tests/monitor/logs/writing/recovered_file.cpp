// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/logs/writing/recovered_file.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <span>

#include "monitor/logs/writing/copies.h"

namespace galilean::logs {
namespace {

constexpr std::uint64_t kMostLost_ns = 1'000'000'000;

}  // namespace

void promise(bool holds, const std::string& sentence) {
  if (holds) return;
  std::cerr << "broken: " << sentence << std::endl;
  std::exit(1);
}

RecoveredFile recover(const std::string& broken, const std::string& recovered) {
  RecoveredFile result;
  result.code = copy_recordings(
      "recover",
      {.files = {broken}, .output = {.path = recovered, .replace = true}, .read_again = true});
  promise(result.code == 0 || result.code == 1 || result.code == 3,
          broken + ": the exit code is " + std::to_string(result.code));
  if (result.code == 1) return result;
  const auto file = mcap::FileSource::open(recovered);
  promise(file.ok(), broken + ": nothing was written");
  auto samples = read_samples(file.value());
  promise(samples.has_value(), broken + ": what was recovered is not whole");
  result.samples = std::move(*samples);
  return result;
}

void promise_all_but_a_second(const std::vector<Sample>& recovered,
                              const std::vector<Sample>& samples, std::size_t accepted,
                              const std::string& name) {
  promise(recovered.size() <= samples.size() &&
              std::ranges::equal(recovered, std::span(samples).first(recovered.size())),
          name + ": what was recovered is not how the recording begins");
  if (recovered.size() >= accepted) return;
  const auto lost_ns = samples[accepted - 1].log_ns - samples[recovered.size()].log_ns;
  promise(lost_ns < kMostLost_ns, name + ": " + std::to_string(lost_ns) + " ns are lost");
}

void promise_one_second(const std::vector<Sample>& recovered, const std::vector<Sample>& samples,
                        const std::string& name) {
  auto next = recovered.begin();
  std::optional<std::uint64_t> first_lost_ns;
  for (const auto& sample : samples) {
    if (next != recovered.end() && *next == sample) {
      ++next;
      continue;
    }
    if (!first_lost_ns) first_lost_ns = sample.log_ns;
    const auto lost_ns = sample.log_ns - *first_lost_ns;
    promise(lost_ns < kMostLost_ns, name + ": " + std::to_string(lost_ns) + " ns are lost");
  }
  promise(next == recovered.end(), name + ": a message was recovered that is none of it");
}

}  // namespace galilean::logs
