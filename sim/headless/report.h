// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "sim/headless/headless.h"

namespace galilean::sim {

/// Returns the results of a headless contest as one JSON object.
[[nodiscard]] nlohmann::ordered_json report(const HeadlessContest& contest,
                                            const HeadlessOptions& options,
                                            const bhdl::Program& program, double wall_s);

/// Returns a report in a few lines for people.
[[nodiscard]] std::string summary(const nlohmann::ordered_json& report);

}  // namespace galilean::sim
