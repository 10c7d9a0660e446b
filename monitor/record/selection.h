// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "core/wire/endpoints.h"

namespace galilean::monitor {

/// Which pictures are recorded. They are costly, because robots encode pictures only for readers.
enum class Pictures {
  kNone,
  kCamera,  ///< those of cameras, and not those of the channels that are made of them
  kAll
};

/// Returns whether the writer sends compressed pictures.
[[nodiscard]] bool is_picture(const wire::EndpointInfo& writer);

/// Returns whether the writer sends what each tick of a robot read.
[[nodiscard]] bool is_inputs(const wire::EndpointInfo& writer);

/// Which topics are recorded.
struct Selection {
  std::vector<std::regex> topics;    ///< one must match a part of a topic's name; none: all topics
  std::vector<std::regex> excluded;  ///< none may match a part of it
  Pictures pictures = Pictures::kAll;
  /// What each tick read, too, which robots send to readers alone. `topics` need not match it.
  bool inputs = false;
  std::function<bool(const wire::EndpointInfo&)> wants;  ///< must be true, too; empty: it is

  /// Returns whether what this writer sends is recorded. The requests and replies of ROS 2's
  /// services are no topics, and what recorders tell of themselves stands in their files.
  [[nodiscard]] bool takes(const wire::EndpointInfo& writer) const;
  /// Returns whether `excluded` matches what the ticks of a robot read, however it is called.
  [[nodiscard]] bool excludes_inputs_of_all() const;

 private:
  [[nodiscard]] bool excludes(const std::string& name) const;
};

/// Returns whether the topic carries the requests or the replies of a service of ROS 2.
[[nodiscard]] bool is_service(std::string_view topic) noexcept;
/// Returns whether it is one of those by which recorders are steered and tell how they are.
[[nodiscard]] bool is_of_recorders(std::string_view topic) noexcept;

}  // namespace galilean::monitor
