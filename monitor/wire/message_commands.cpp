// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <iostream>
#include <set>

#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/wire/gap_statistics.h"
#include "monitor/wire/message_text.h"
#include "monitor/wire/topic_commands.h"
#include "monitor/wire/topic_name.h"
#include "monitor/wire/wire_session.h"

namespace galilean::monitor {
namespace {

std::string json_line(const MessageTree& tree) {
  return ordered_json_text(tree) + '\n';
}

/// Returns what echo prints of a message. Errors: it has no such field.
Result<std::string> echoed(const MessageTree& message, const TopicOptions& options) {
  const auto field = find_field(message, options.field);
  if (!field) return field.error();
  const MessageTree shown = field.value() ? *field.value() : MessageTree();
  return options.json ? json_line(shown) : readable_text(shown) + "---\n";
}

/// Prints messages as they come.
class Echo {
 public:
  Echo(TopicReader& reader, const TopicOptions& options) : reader_(reader), options_(options) {}

  /// Prints what came. A message that cannot be decoded is told of on standard error, each reason
  /// once. Errors: a message has no field as asked for.
  Result<void> print_new() {
    Result<void> done;
    reader_.take([&](const wire::Received& received) {
      if (done && !enough()) done = print(received);
    });
    return done;
  }
  /// Returns whether as many were printed as asked for, or nobody reads them any more.
  [[nodiscard]] bool enough() const {
    return !std::cout || (options_.count && count_ >= options_.count);
  }
  void tell_notes() {
    for (const auto& note : reader_.take_notes()) tell(note);
  }

 private:
  Result<void> print(const wire::Received& received) {
    const auto message = reader_.decode(received);
    tell_notes();
    if (!message) return tell(message.error().message), Result<void>();
    const auto text = echoed(message.value(), options_);
    if (!text) return text.error();
    std::cout << text.value() << std::flush;
    ++count_;
    return {};
  }
  void tell(const std::string& sentence) {
    if (told_.insert(sentence).second) note_topic_verb("echo", sentence);
  }

  TopicReader& reader_;
  const TopicOptions& options_;
  std::set<std::string> told_;
  int count_ = 0;
};

int tell_rate(const std::string& topic, const GapStatistics& statistics, double seconds,
              bool json) {
  const auto figures = statistics.figures();
  if (json) {
    MessageTree tree{{"topic", topic}, {"messages", statistics.messages()}, {"seconds", seconds}};
    for (const auto& [name, figure] : {std::pair{"rate_hz", &GapStatistics::Figures::rate_hz},
                                       {"least_gap_s", &GapStatistics::Figures::least_s},
                                       {"most_gap_s", &GapStatistics::Figures::most_s},
                                       {"mean_gap_s", &GapStatistics::Figures::mean_s},
                                       {"deviation_s", &GapStatistics::Figures::deviation_s},
                                       {"bytes_per_s", &GapStatistics::Figures::bytes_per_s}})
      tree[name] = figures ? MessageTree((*figures).*figure) : MessageTree();
    std::cout << json_line(tree) << std::flush;
  } else if (figures) {
    std::printf(
        "%s: %.2f messages/s, %.0f bytes/s; gaps %.4f to %.4f s, mean %.4f s, standard deviation "
        "%.4f s; %s\n",
        visible(topic).c_str(), figures->rate_hz, figures->bytes_per_s, figures->least_s,
        figures->most_s, figures->mean_s, figures->deviation_s,
        plural(statistics.messages(), "message").c_str());
  } else if (statistics.messages() > 0) {
    std::printf("%s: %s, too few for a rate\n", visible(topic).c_str(),
                plural(statistics.messages(), "message").c_str());
  }
  return 0;
}

}  // namespace

int echo_topic(const TopicOptions& options) {
  const auto session = WireSession::join(options.domain);
  if (!session) return fail_topic_verb("echo", session.error().message);
  const auto topic = session.value()->find(options.name);
  if (session.value()->ended()) return 0;
  if (!topic) return fail_topic_verb("echo", topic.error().message);
  const auto reader = session.value()->read(topic.value());
  const auto prepared = reader->prepare();
  if (session.value()->ended()) return 0;
  if (!prepared) return fail_topic_verb("echo", prepared.error().message);
  Echo echo(*reader, options);
  echo.tell_notes();
  Result<void> done;
  session.value()->wait(kForEver, [&] {
    done = echo.print_new();
    return !done || echo.enough();
  });
  return done ? 0 : fail_topic_verb("echo", done.error().message);
}

int measure_rate(const TopicOptions& options) {
  // What a writer kept for late joiners comes at once, and says nothing of its rate.
  constexpr Duration kKeptMessages = std::chrono::milliseconds(300);
  const auto session = WireSession::join(options.domain);
  if (!session) return fail_topic_verb("rate", session.error().message);
  const auto topic = session.value()->find(options.name);
  if (session.value()->ended()) return 0;
  if (!topic) return fail_topic_verb("rate", topic.error().message);
  const auto reader = session.value()->read(topic.value());
  session.value()->wait(kKeptMessages, [&] { return reader->take([](const auto&) {}), false; });
  GapStatistics statistics;
  const Time start = session.value()->now();
  session.value()->wait(options.count ? kForEver : from_seconds(options.window_s), [&] {
    reader->take([&](const wire::Received& received) {
      if (!options.count || statistics.messages() < static_cast<std::size_t>(options.count))
        statistics.add(session.value()->now(), received.cdr.size());
    });
    return options.count && statistics.messages() >= static_cast<std::size_t>(options.count);
  });
  const double seconds = to_seconds(session.value()->now() - start);
  const std::string shown = shown_topic(topic.value().dds_topic);
  tell_rate(shown, statistics, seconds, options.json);
  if (statistics.messages() > 0 || session.value()->ended()) return 0;
  char sentence[64];
  std::snprintf(sentence, sizeof sentence, " in %.1f s", seconds);
  return fail_topic_verb("rate", "nothing came on " + visible(shown) + sentence);
}

}  // namespace galilean::monitor
