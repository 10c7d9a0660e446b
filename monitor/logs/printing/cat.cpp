// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/printing/cat.h"

#include <cstdio>
#include <iostream>

#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/visible_text.h"
#include "monitor/logs/reading/undecoded.h"
#include "monitor/record/damage_text.h"
#include "monitor/record/times.h"
#include "monitor/wire/message_text.h"

namespace galilean::logs {
namespace {

constexpr const char* kCat = "galilean log cat";

int fail_cat(const std::string& sentence) {
  std::cerr << kCat << ": " << sentence << '\n';
  return kFailed;
}

/// Returns "12.300 2023-11-14T22:13:32.300Z /io/state".
std::string heading(const mcap::Message& message, double at_s, const std::string& topic) {
  char seconds[48];
  std::snprintf(seconds, sizeof seconds, "%.3f ", at_s);
  return seconds + monitor::iso_time(message.log_ns) + ' ' + visible(topic);
}

class Printer {
 public:
  Printer(const Recording& recording, const CatOptions& options)
      : recording_(recording), options_(options), trees_(recording.summary()), undecoded_(kCat) {}

  /// Errors: the message has no field as asked for.
  Result<void> print(const mcap::Message& message, double at_s) {
    const auto tree = trees_.decode(message);
    const std::string topic = monitor::topic_of(message.channel_id, recording_.summary());
    if (!tree) {
      undecoded_.add(topic, tree.error().message);
      if (options_.json) print_json(message, at_s, topic, nullptr);
      return {};
    }
    const auto field = monitor::find_field(tree.value(), options_.field);
    if (!field) return Error{"in messages of " + visible(topic) + " " + field.error().message};
    if (options_.json)
      print_json(message, at_s, topic, field.value());
    else
      print_text(message, at_s, topic, field.value());
    return {};
  }
  [[nodiscard]] int finish() { return undecoded_.finish(); }

 private:
  /// Times and numbers of 64 bits are texts, since numbers of JSON have less everywhere.
  void print_json(const mcap::Message& message, double at_s, const std::string& topic,
                  const monitor::MessageTree* content) {
    monitor::MessageTree line{{"at_s", at_s},
                              {"log_ns", std::to_string(message.log_ns)},
                              {"publish_ns", std::to_string(message.publish_ns)},
                              {"topic", topic},
                              {"sequence", message.sequence}};
    line[options_.field.empty() ? "message" : "value"] =
        content ? *content : monitor::MessageTree();
    std::cout << ordered_json_text(line) << '\n';
  }

  void print_text(const mcap::Message& message, double at_s, const std::string& topic,
                  const monitor::MessageTree* content) {
    const std::string text = content ? monitor::readable_text(*content) : "none\n";
    const bool one_line = !options_.field.empty() && text.find('\n') + 1 == text.size();
    std::cout << heading(message, at_s, topic) << (one_line ? " " : "\n") << text
              << (one_line ? "" : "---\n");
  }

  const Recording& recording_;
  const CatOptions& options_;
  monitor::MessageTrees trees_;
  Undecoded undecoded_;
};

}  // namespace

int print_messages(const CatOptions& options) {
  const auto recording = Recording::open(options.file);
  if (!recording) return fail_cat(recording.error().message);
  auto messages =
      SelectedMessages::of(recording.value(), options.selection, SelectedMessages::kMemoryBytes,
                           ShowsProgress::kUnlessPrinting);
  if (!messages) return fail_cat(messages.error().message);
  Printer printer(recording.value(), options);
  int left = options.count;
  while (const mcap::Message* message = messages.value().next()) {
    if (auto done = printer.print(*message, messages.value().at_s()); !done)
      return fail_cat(done.error().message);
    if (!std::cout || (options.count > 0 && --left == 0)) break;
  }
  if (!std::cout.flush()) return kFailed;
  tell_nothing(kCat, options.selection, messages.value());
  const int undecoded = printer.finish();
  const int damaged = tell_damage(kCat, messages.value());
  return undecoded != 0 ? undecoded : damaged;
}

}  // namespace galilean::logs
