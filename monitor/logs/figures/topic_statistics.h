// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "monitor/logs/figures/number_statistics.h"
#include "monitor/logs/reading/selection.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::logs {

/// How a topic's messages come: how often, how evenly, how large, how late, and with which gaps in
/// their numbers.
class TopicStatistics {
 public:
  /// @param at_s      the message's time since the recording's start, without silences
  /// @param numbered  whether gaps in the numbers of its channel are missing messages
  void add(const mcap::Message& message, double at_s, bool numbered = true);
  /// Takes how many are missing by what the recorder counted, which knows better than the numbers;
  /// nothing: it could not count them.
  void set_missing(std::optional<std::uint64_t> messages);
  /// Takes how many are lost by damage. The numbers tell of some of these, but not of those behind
  /// the last that is there; what a recorder counted has none of them.
  void add_damaged(std::uint64_t messages);
  /// Returns the figures, with null for what so few messages do not tell.
  [[nodiscard]] monitor::MessageTree figures() const;

 private:
  void note_number(std::uint16_t channel, std::uint32_t sequence);

  std::uint64_t messages_ = 0, bytes_ = 0;
  std::optional<std::uint64_t> missing_ = 0;  ///< nothing: the numbers do not tell
  bool was_counted_ = false;                  ///< `missing_` is what the recorder counted
  double first_s_ = 0, last_s_ = 0;
  NumberStatistics gaps_s_, size_bytes_, delay_s_;
  std::map<std::uint16_t, std::uint32_t> newest_;  ///< number of the newest, by channel
};

/// What the values of one field are.
class FieldStatistics {
 public:
  void add(double at_s, const monitor::MessageTree& value);
  [[nodiscard]] monitor::MessageTree figures() const;

 private:
  NumberStatistics numbers_;
  double first_ = 0, last_ = 0, least_at_s_ = 0, most_at_s_ = 0;
  std::uint64_t others_ = 0;                    ///< values that are no numbers
  std::map<std::string, std::uint64_t> words_;  ///< how often each text came
  std::uint64_t more_words_ = 0;                ///< how often texts came that are not in `words_`
};

}  // namespace galilean::logs
