// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/reading/recording.h"

#include <set>
#include <string_view>
#include <utility>

#include "core/progress_bar.h"
#include "core/spelling.h"
#include "core/visible_text.h"

namespace galilean::logs {
namespace {

/// Of more topics than so many, the rest is counted.
constexpr std::size_t kMostListed = 12;

std::string_view without_slash(std::string_view name) {
  return name.starts_with('/') ? name.substr(1) : name;
}

std::set<std::string> topics_of(const mcap::Summary& summary) {
  std::set<std::string> topics;
  for (const auto& [id, channel] : summary.channels) topics.insert(channel.topic);
  return topics;
}

std::string list_of(const std::set<std::string>& topics) {
  std::string text;
  std::size_t listed = 0;
  for (const auto& topic : topics) {
    if (listed++ == kMostListed)
      return text + " and " + std::to_string(topics.size() - kMostListed) + " more";
    text += (text.empty() ? "" : ", ") + visible(topic);
  }
  return text;
}

}  // namespace

Result<Recording> Recording::open(const std::string& path, mcap::Depth depth) {
  auto opened = mcap::FileSource::open(path);
  if (!opened) return opened.error();
  auto file = std::make_unique<mcap::FileSource>(std::move(opened).value());
  const auto bar = progress_on_terminal("reading " + path);
  auto summary = mcap::summarize(*file, depth, [&](double done) {
    if (bar) bar->show(done);
  });
  if (!summary) return Error{path + " " + summary.error().message};
  return Recording(path, std::move(file), std::move(summary).value());
}

Recording::Recording(std::string path, std::unique_ptr<mcap::FileSource> file,
                     mcap::Summary summary)
    : path_(std::move(path)), file_(std::move(file)), summary_(std::move(summary)) {}

Result<std::vector<std::uint16_t>> Recording::channels_of(const std::string& topic) const {
  std::vector<std::uint16_t> ids;
  for (const auto& [id, channel] : summary_.channels)
    if (without_slash(channel.topic) == without_slash(topic)) ids.push_back(id);
  if (!ids.empty()) return ids;
  const auto known = topics_of(summary_);
  const std::vector<std::string_view> names(known.begin(), known.end());
  const std::string meant = meant_name("/" + std::string(without_slash(topic)), names);
  const std::string sentence = path_ + " has no topic '" + visible(topic) + "'";
  if (!meant.empty()) return Error{sentence + "; did you mean '" + visible(meant) + "'?"};
  return Error{sentence + (known.empty() ? "" : "; it has " + list_of(known))};
}

Result<std::string> Recording::only_topic() const {
  const auto known = topics_of(summary_);
  if (known.size() == 1) return *known.begin();
  if (known.empty()) return Error{path_ + " has no topic"};
  return Error{path_ + " has several topics; name one of " + list_of(known)};
}

}  // namespace galilean::logs
