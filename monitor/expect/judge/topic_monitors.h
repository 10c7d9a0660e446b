// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "monitor/expect/judge/topic_monitor.h"
#include "monitor/expect/language/expectation.h"

namespace galilean::expect {

/// Returns the monitor of a claim about a topic, or nullptr if the claim is about conditions.
[[nodiscard]] std::unique_ptr<TopicMonitor> make_topic_monitor(const Claim& claim);
/// Returns the topic that a claim is about, or nullptr.
[[nodiscard]] const TopicName* topic_of(const Claim& claim);

}  // namespace galilean::expect
