// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/comparing/difference.h"

#include <algorithm>
#include <utility>

#include "core/json_text.h"
#include "monitor/logs/comparing/channel_differences.h"
#include "monitor/logs/comparing/message_groups.h"
#include "monitor/logs/printing/columns.h"
#include "monitor/schemas/message_trees.h"

namespace galilean::logs {
namespace {

std::map<std::string, std::string> values_of(const monitor::MessageTree& tree) {
  std::map<std::string, std::string> values;
  for_each_value(tree, "", [&](const std::string& name, const monitor::MessageTree& value) {
    values[name] = ordered_json_text(value);
  });
  return values;
}

class Comparing {
 public:
  Comparing(SelectedMessages& first, SelectedMessages& second)
      : first_(first),
        second_(second),
        first_trees_(first.recording().summary()),
        second_trees_(second.recording().summary()) {}

  Result<Difference> run() {
    found_.channels = channel_differences(first_.recording(), second_.recording());
    MessageGroups first(first_), second(second_);
    while (first.has_next() || second.has_next()) {
      const bool a =
          first.has_next() && (!second.has_next() || first.next_ns() <= second.next_ns());
      const bool b =
          second.has_next() && (!first.has_next() || second.next_ns() <= first.next_ns());
      auto of_first =
          a ? first.take() : Result<std::vector<OwnedMessage>>(std::vector<OwnedMessage>{});
      auto of_second =
          b ? second.take() : Result<std::vector<OwnedMessage>>(std::vector<OwnedMessage>{});
      if (!of_first) return of_first.error();
      if (!of_second) return of_second.error();
      compare_groups(of_first.value(), of_second.value());
    }
    return std::move(found_);
  }

 private:
  void compare_groups(std::vector<OwnedMessage>& first, std::vector<OwnedMessage>& second) {
    drop_equal(first, second);
    for (auto& message : first) {
      const auto other = std::ranges::find(second, message.topic, &OwnedMessage::topic);
      if (other == second.end()) {
        ++found_.topics[message.topic].only_first;
        list(DifferentMessage::Kind::kOnlyFirst, message);
        continue;
      }
      ++found_.topics[message.topic].changed;
      list_changed(message, *other);
      second.erase(other);
    }
    for (const auto& message : second) {
      ++found_.topics[message.topic].only_second;
      list(DifferentMessage::Kind::kOnlySecond, message);
    }
  }

  /// Takes the pairs of equal messages out of both, and counts them.
  void drop_equal(std::vector<OwnedMessage>& first, std::vector<OwnedMessage>& second) {
    std::erase_if(first, [&](const OwnedMessage& message) {
      const auto same = std::ranges::find_if(
          second, [&](const OwnedMessage& other) { return message.equals(other); });
      if (same == second.end()) return false;
      ++found_.topics[message.topic].equal;
      second.erase(same);
      return true;
    });
  }

  void list(DifferentMessage::Kind kind, const OwnedMessage& message) {
    if (found_.messages.size() == Difference::kMostListed) return;
    found_.messages.push_back({kind, message.topic, message.at_s, message.head.log_ns});
  }

  void list_changed(OwnedMessage& first, OwnedMessage& second) {
    if (found_.messages.size() == Difference::kMostListed) return;
    list(DifferentMessage::Kind::kChanged, first);
    auto& listed = found_.messages.back();
    if (first.data == second.data) {
      const bool numbers = first.sequence != second.sequence;
      listed.field = numbers ? "the message's number" : "the time at which it was sent";
      listed.first = std::to_string(numbers ? first.sequence : first.head.publish_ns);
      listed.second = std::to_string(numbers ? second.sequence : second.head.publish_ns);
      return;
    }
    first.head.data = first.data;
    second.head.data = second.data;
    const auto a = first_trees_.decode(first.head), b = second_trees_.decode(second.head);
    if (a && b) find_first_field(a.value(), b.value(), listed);
  }

  static void find_first_field(const monitor::MessageTree& first,
                               const monitor::MessageTree& second, DifferentMessage& to) {
    const auto a = values_of(first), b = values_of(second);
    const auto differs = [&](const auto& x, const auto& y) {
      for (const auto& [name, value] : x) {
        const auto other = y.find(name);
        if (other != y.end() && other->second == value) continue;
        to.field = name;
        return true;
      }
      return false;
    };
    if (!differs(a, b) && !differs(b, a)) return;
    to.first = a.contains(to.field) ? a.at(to.field) : "nothing";
    to.second = b.contains(to.field) ? b.at(to.field) : "nothing";
  }

  SelectedMessages &first_, &second_;
  monitor::MessageTrees first_trees_, second_trees_;
  Difference found_;
};

}  // namespace

bool Difference::any() const {
  return !channels.empty() ||
         std::ranges::any_of(topics, [](const auto& each) { return each.second.any(); });
}

Result<Difference> compare(SelectedMessages& first, SelectedMessages& second) {
  return Comparing(first, second).run();
}

}  // namespace galilean::logs
