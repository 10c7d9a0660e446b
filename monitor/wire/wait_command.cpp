// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <iostream>

#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/wire/expression.h"
#include "monitor/wire/topic_commands.h"
#include "monitor/wire/wire_session.h"

namespace galilean::monitor {
namespace {

/// The topics of an expression, read as soon as they have writers.
class Watch {
 public:
  Watch(WireSession& session, Expression expression)
      : session_(session), expression_(std::move(expression)) {
    for (auto& topic : expression_.topics()) sources_.push_back({.topic = std::move(topic)});
  }

  /// Returns whether the expression holds, after any of the messages that came meanwhile.
  Result<bool> look() {
    for (auto& source : sources_) {
      if (!source.reader) open(source);
      if (!source.reader) continue;
      Result<bool> held = false;
      source.reader->take([&](const wire::Received& received) {
        if (!held || held.value()) return;
        auto message = source.reader->decode(received);
        if (!message) return source.refuse(message.error());
        newest_[source.topic] = std::move(message).value();
        held = expression_.holds(newest_);
      });
      for (const auto& note : source.reader->take_notes()) note_topic_verb("wait", note);
      if (!held || held.value()) return held;
    }
    return false;
  }
  /// Returns a clause on each topic that sent nothing, or messages that were left out.
  [[nodiscard]] std::string complaints() {
    std::string text;
    for (const auto& source : sources_) {
      if (source.undecoded > 0)
        text += "; " + plural(source.undecoded, "message") + " of '" + visible(source.topic) +
                (source.undecoded == 1 ? "' was left out: " : "' were left out: ") + source.reason;
      else if (!newest_.contains(source.topic))
        text += "; " + silence_of(source.topic);
    }
    return text;
  }

 private:
  struct Source {
    std::string topic;
    std::unique_ptr<TopicReader> reader = {};
    std::size_t undecoded = 0;
    std::string reason = {};  ///< why the newest of them could not be decoded

    void refuse(const Error& error) {
      ++undecoded;
      reason = error.message;
    }
  };

  std::string silence_of(const std::string& topic) {
    const auto found = session_.find_now(topic);
    return found ? "nothing came on '" + visible(topic) + "'" : found.error().message;
  }

  void open(Source& source) {
    auto found = session_.find_now(source.topic);
    if (found) source.reader = session_.read(std::move(found).value());
  }

  WireSession& session_;
  Expression expression_;
  Expression::Newest newest_;
  std::vector<Source> sources_;
};

}  // namespace

int wait_for_expression(const TopicOptions& options) {
  auto expression = Expression::parse(options.name);
  if (!expression) return fail_topic_verb("wait", expression.error().message), kWrongUsage;
  const auto session = WireSession::join(options.domain);
  if (!session) return fail_topic_verb("wait", session.error().message);
  Watch watch(*session.value(), std::move(expression).value());
  Result<bool> held = false;
  const Time start = session.value()->now();
  session.value()->wait(options.timeout_s > 0 ? from_seconds(options.timeout_s) : kForEver, [&] {
    held = watch.look();
    return !held || held.value();
  });
  if (!held) return fail_topic_verb("wait", held.error().message);
  const double seconds = to_seconds(session.value()->now() - start);
  if (options.json)
    std::cout << json_text({{"holds", held.value()}, {"seconds", seconds}}) << std::endl;
  if (held.value()) return 0;
  char after[64];
  std::snprintf(after, sizeof after, " within %.1f s", seconds);
  return fail_topic_verb(
      "wait", "'" + visible(options.name) + "' did not come true" + after + watch.complaints());
}

}  // namespace galilean::monitor
