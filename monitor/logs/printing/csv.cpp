// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/printing/csv.h"

#include <cstdio>
#include <iostream>

#include "core/command_line/exit_code.h"
#include "core/visible_text.h"
#include "monitor/logs/printing/columns.h"
#include "monitor/logs/reading/undecoded.h"
#include "monitor/record/times.h"
#include "monitor/wire/message_text.h"

namespace galilean::logs {
namespace {

constexpr const char* kCsv = "galilean log csv";

int fail_csv(const std::string& sentence) {
  std::cerr << kCsv << ": " << sentence << '\n';
  return kFailed;
}

class Table {
 public:
  Table(const Recording& recording, const CsvOptions& options, std::string topic)
      : recording_(recording),
        options_(options),
        topic_(std::move(topic)),
        trees_(recording.summary()),
        undecoded_(kCsv) {
    if (options_.fields.empty()) fields_.push_back("");
    fields_.insert(fields_.end(), options_.fields.begin(), options_.fields.end());
    columns_.resize(fields_.size());
  }

  /// Errors: a field is not there, or there are too many values.
  Result<void> find_columns() {
    return for_each_message([&](const mcap::Message&, double, const monitor::MessageTree& tree) {
      return add_columns(tree);
    });
  }

  Result<void> print() {
    print_header();
    return for_each_message(
        [&](const mcap::Message& message, double at_s, const monitor::MessageTree& tree) {
          print_row(message, at_s, tree);
          return Result<void>();
        });
  }

  /// Returns the exit code of what the second reading found.
  [[nodiscard]] int finish() const { return undecoded_.finish() != 0 ? kIncomplete : damaged_; }

 private:
  template <class Take>
  Result<void> for_each_message(Take take) {
    const Selection selection{.topics = {topic_}, .from_s = options_.from_s, .to_s = options_.to_s};
    auto messages = SelectedMessages::of(recording_, selection, SelectedMessages::kMemoryBytes,
                                         ShowsProgress::kUnlessPrinting);
    if (!messages) return messages.error();
    undecoded_ = Undecoded(kCsv);
    while (const mcap::Message* message = messages.value().next()) {
      const auto tree = trees_.decode(*message);
      if (!tree)
        undecoded_.add(topic_, tree.error().message);
      else if (auto done = take(*message, messages.value().at_s(), tree.value()); !done)
        return done;
      if (!std::cout) break;
    }
    if (second_) {
      tell_nothing(kCsv, selection, messages.value());
      damaged_ = tell_damage(kCsv, messages.value());
    }
    second_ = true;
    return {};
  }

  Result<void> add_columns(const monitor::MessageTree& tree) {
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const auto field = monitor::find_field(tree, fields_[i]);
      if (!field) return Error{"in messages of " + visible(topic_) + " " + field.error().message};
      if (!field.value()) continue;  // an index beyond the end of its list
      if (auto done = columns_[i].add(*field.value(), fields_[i]); !done) return done;
    }
    return {};
  }

  void print_header() {
    std::cout << "at_s,log_time";
    for (const auto& columns : columns_)
      for (const auto& name : columns.names()) std::cout << ',' << csv_text(visible(name));
    std::cout << "\r\n";
  }

  void print_row(const mcap::Message& message, double at_s, const monitor::MessageTree& tree) {
    char seconds[48];
    std::snprintf(seconds, sizeof seconds, "%.9f", at_s);
    std::cout << seconds << ',' << monitor::iso_time(message.log_ns);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      cells_.assign(columns_[i].names().size(), {});
      const auto field = monitor::find_field(tree, fields_[i]);
      if (field && field.value())
        for_each_value(*field.value(), fields_[i],
                       [&](const std::string& name, const monitor::MessageTree& value) {
                         cells_[columns_[i].place_of(name)] = csv_cell(value);
                       });
      for (const auto& cell : cells_) std::cout << ',' << cell;
    }
    std::cout << "\r\n";
  }

  const Recording& recording_;
  const CsvOptions& options_;
  std::string topic_;
  monitor::MessageTrees trees_;
  Undecoded undecoded_;
  std::vector<std::string> fields_;
  std::vector<Columns> columns_;  ///< by field
  std::vector<std::string> cells_;
  bool second_ = false;
  int damaged_ = 0;
};

}  // namespace

int print_csv(const CsvOptions& options) {
  const auto recording = Recording::open(options.file);
  if (!recording) return fail_csv(recording.error().message);
  const auto topic =
      options.topic.empty() ? recording.value().only_topic() : Result<std::string>(options.topic);
  if (!topic) return fail_csv(topic.error().message);
  Table table(recording.value(), options, topic.value());
  auto done = table.find_columns();
  if (done) done = table.print();
  if (!done) return fail_csv(done.error().message);
  return std::cout.flush() ? table.finish() : kFailed;
}

}  // namespace galilean::logs
