// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/recording_coverage.h"

#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/coverage/recorded_coverage.h"
#include "monitor/mcap/message_reader.h"
#include "monitor/record/copy_losses.h"
#include "monitor/record/damage_text.h"

namespace galilean::monitor {
namespace {

constexpr std::size_t kMemoryBytes = std::size_t{16} << 20;
/// Of more damages than so many, the rest is counted.
constexpr std::size_t kMostDamages = 20;

/// Returns what is damaged, in sentences without a full stop. What is damaged is met by the survey
/// of the file, by the reader, or by both.
std::vector<std::string> damage_sentences(const mcap::Summary& summary,
                                          const std::vector<mcap::Damage>& met) {
  std::vector<std::string> sentences;
  std::set<std::uint64_t> offsets;
  for (const auto* damages : {&summary.damages, &met})
    for (const auto& damage : *damages)
      if (offsets.insert(damage.offset).second && offsets.size() <= kMostDamages)
        sentences.push_back(damage_text(damage, summary));
  if (offsets.size() > kMostDamages)
    sentences.push_back("it has " + plural(offsets.size() - kMostDamages, "damage") + " more");
  return sentences;
}

std::vector<std::string> end_sentences(const mcap::Summary& summary) {
  std::vector<std::string> sentences;
  if (!summary.closed)
    sentences.emplace_back(summary.being_written
                               ? "it is being written, and what it has so far was counted"
                               : "it was not closed properly, and what can be read was counted");
  for (const auto& copy : copy_losses(summary))
    sentences.push_back("it is a copy: " + copy_loss_text(copy));
  return sentences;
}

nlohmann::json programs_json(const RecordedCoverage& coverage) {
  auto list = nlohmann::json::array();
  for (const auto& [hash, program] : coverage.programs()) {
    nlohmann::json json = program.figures();
    json["hash"] = hash;
    list.push_back(std::move(json));
  }
  return list;
}

void append(std::vector<std::string> sentences, std::vector<std::string>& to) {
  to.insert(to.end(), std::make_move_iterator(sentences.begin()),
            std::make_move_iterator(sentences.end()));
}

}  // namespace

HttpResponse coverage_response(const std::string& name, const OpenedRecording& recording,
                               const std::atomic<bool>& stops) {
  const auto summary = mcap::summarize(*recording.source, mcap::Depth::kIndexes);
  if (!summary) return problem(422, "'" + visible(name) + "' " + summary.error().message + ".");
  RecordedCoverage coverage;
  coverage.begin(summary.value());
  mcap::MessageReader reader(*recording.source, summary.value().blocks, kMemoryBytes);
  while (const auto* message = reader.next()) {
    if (stops) return problem(503, "The monitor ends, and does not count any more.");
    coverage.take(*message);
  }
  auto uncounted = coverage.uncounted();
  append(end_sentences(summary.value()), uncounted);
  append(damage_sentences(summary.value(), reader.damages()), uncounted);
  return json_response(
      {{"name", name}, {"programs", programs_json(coverage)}, {"uncounted", std::move(uncounted)}});
}

}  // namespace galilean::monitor
