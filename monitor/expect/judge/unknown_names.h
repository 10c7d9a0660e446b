// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "monitor/expect/language/expectation.h"

namespace galilean::expect {

/// Returns "io has no variable 'tras'; did you mean 'trash'?".
[[nodiscard]] std::string unknown_name(const std::string& robot, std::string_view kind,
                                       const std::string& name, const std::set<std::string>& known);
/// Returns "; did you mean 'io'?" for the name of a robot that was not heard, or an empty text.
[[nodiscard]] std::string meant_robot(std::string_view robot, const std::set<std::string>& heard);
/// Returns "; did you mean '/io/state'?" for a topic on which nothing came, if it is that of a
/// robot that was not heard, or an empty text. `robot` is whose relative topics are meant.
[[nodiscard]] std::string meant_topic(const TopicName& topic, const std::string& robot,
                                      const std::set<std::string>& heard);

}  // namespace galilean::expect
