// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/comparing/verify.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>

#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/plural.h"
#include "core/progress_bar.h"
#include "core/visible_text.h"
#include "monitor/logs/reading/attachments.h"
#include "monitor/logs/reading/selection.h"
#include "monitor/record/copy_losses.h"
#include "monitor/record/damage_text.h"
#include "monitor/schemas/message_trees.h"

namespace galilean::logs {
namespace {

using Json = nlohmann::ordered_json;

/// What is wrong with a recording, and what of it was not looked into.
struct Findings {
  std::vector<std::string> problems, notes;  ///< sentences without a full stop
  std::uint64_t messages = 0;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream rest(text);
  for (std::string line; std::getline(rest, line);) lines.push_back(line);
  return lines;
}

/// Decodes every message. Messages of types that are not known are only noted.
void decode_all(const Recording& recording, Findings& to) {
  const auto& summary = recording.summary();
  const monitor::MessageTrees trees(summary);
  std::map<std::uint16_t, std::uint64_t> broken;
  const auto bar = progress_on_terminal("decoding " + recording.path());
  mcap::MessageReader reader(recording.source(), summary.blocks);
  while (const mcap::Message* message = reader.next()) {
    ++to.messages;
    if (bar) bar->show(reader.progress());
    const bool readable = summary.channels.contains(message->channel_id) &&
                          trees.problem_of(message->channel_id).empty();
    if (readable && !trees.decode(*message)) ++broken[message->channel_id];
  }
  for (const auto& [channel, messages] : broken)
    to.problems.push_back(plural(messages, "message") + " of " +
                          visible(monitor::topic_of(channel, summary)) +
                          agreeing(messages, " is", " are") + " not whole");
  for (const auto& [id, channel] : summary.channels)
    if (auto problem = trees.problem_of(id); !problem.empty())
      to.notes.push_back("not looked into: " + problem);
}

Findings look_into(const Recording& recording) {
  Findings findings;
  const auto& summary = recording.summary();
  for (auto& line : lines_of(monitor::condition_text(recording.path(), summary)))
    (line.starts_with("silence: ") || summary.being_written ? findings.notes : findings.problems)
        .push_back(std::move(line));
  for (const auto& copy : monitor::copy_losses(summary))
    findings.notes.push_back(monitor::copy_loss_text(copy));
  if (summary.being_written && summary.recovered()) findings.problems.push_back("it is damaged");
  for (const auto& attachment : summary.attachments)
    if (!is_whole(recording.source(), attachment))
      findings.problems.push_back("the attachment '" + visible(attachment.name) +
                                  "' does not match its checksum");
  decode_all(recording, findings);
  return findings;
}

std::string in_words(const Recording& recording, const Findings& findings) {
  const auto& summary = recording.summary();
  std::string text = recording.path() + ": " + (findings.problems.empty() ? "whole" : "DAMAGED") +
                     ", " + plural(findings.messages, "message") + " of " +
                     plural(summary.channels.size(), "channel") + ", every checksum compared\n";
  for (const auto& problem : findings.problems) text += "  " + problem + '\n';
  for (const auto& note : findings.notes) text += "  " + note + '\n';
  return text;
}

}  // namespace

int verify_recordings(const VerifyOptions& options) {
  auto list = Json::array();
  int code = 0;
  for (const auto& file : options.files) {
    const auto recording = Recording::open(file, mcap::Depth::kAll);
    if (!recording) {
      std::cerr << "galilean log verify: " << recording.error().message << '\n';
      list.push_back({{"file", file},
                      {"whole", nullptr},
                      {"problems", Json::array({recording.error().message})}});
      code = kFailed;
      continue;
    }
    const auto findings = look_into(recording.value());
    const bool whole = findings.problems.empty();
    if (!whole && code == 0) code = kIncomplete;
    list.push_back({{"file", file},
                    {"whole", whole},
                    {"messages", findings.messages},
                    {"problems", findings.problems},
                    {"notes", findings.notes}});
    if (!options.json) std::cout << in_words(recording.value(), findings) << std::flush;
  }
  if (options.json) std::cout << ordered_json_text(list, 2) << '\n';
  return std::cout.flush() ? code : kFailed;
}

}  // namespace galilean::logs
