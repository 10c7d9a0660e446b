// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/outline.h"

#include "monitor/mcap/summary_section.h"

namespace galilean::mcap {
namespace {

bool suffices(const SummarySection& section) {
  return section.closed && section.checked && section.statistics &&
         section.statistics->channels == section.channels.size() &&
         section.statistics->schemas == section.schemas.size();
}

}  // namespace

Result<Outline> outline(const ByteSource& source) {
  if (const auto right = check_format(source); !right) return right.error();
  auto section = read_summary_section(source);
  if (suffices(section))
    return Outline{.messages = section.statistics->messages,
                   .start_ns = section.statistics->start_ns,
                   .end_ns = section.statistics->end_ns,
                   .schemas = std::move(section.schemas),
                   .channels = std::move(section.channels),
                   .closed = true,
                   .being_written = source.is_being_written()};
  auto summary = summarize(source, Depth::kIndexes);
  if (!summary) return summary.error();
  auto& found = summary.value();
  return Outline{.messages = found.statistics.messages,
                 .start_ns = found.statistics.start_ns,
                 .end_ns = found.statistics.end_ns,
                 .schemas = std::move(found.schemas),
                 .channels = std::move(found.channels),
                 .closed = found.closed,
                 .being_written = found.being_written,
                 .damaged = !found.damages.empty()};
}

Result<void> check_content(const ByteSource& source, const Outline& outline) {
  if (outline.closed || outline.messages > 0 || !outline.channels.empty()) return {};
  if (const auto right = check_header(source); !right) return right.error();
  return Error{"has nothing that can be read behind its header"};
}

}  // namespace galilean::mcap
