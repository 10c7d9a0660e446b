// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/mcap/mcap_reader.h"

namespace galilean::monitor {

/// Returns a sentence without a full stop: what is damaged, how many messages of which time are
/// lost, and of which topics.
[[nodiscard]] std::string damage_text(const mcap::Damage& damage, const mcap::Summary& summary);
/// Returns a sentence without a full stop about the messages that are lost in all; empty if none
/// is.
[[nodiscard]] std::string loss_text(const mcap::Summary& summary);
/// Returns a sentence without a full stop about a time without messages.
[[nodiscard]] std::string silence_text(const mcap::TimeRange& silence);

/// Returns the lines that tell what is wrong with the recording, each with its line end: that it
/// was not closed, each damage, the losses and the silences. Empty if nothing is wrong.
[[nodiscard]] std::string condition_text(const std::string& path, const mcap::Summary& summary);

/// Returns the topic's name; "channel 7" for a channel that no record describes.
[[nodiscard]] std::string topic_of(std::uint16_t channel, const mcap::Summary& summary);

}  // namespace galilean::monitor
