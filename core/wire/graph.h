// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "core/wire/participant.h"

namespace galilean::wire {

/// Finds who writes and who reads each topic of the domain. Processes are named as they joined it.
class Graph {
 public:
  struct Ends {
    std::set<std::string> writers, readers;
    bool operator==(const Ends&) const = default;
  };
  /// The writers and readers of each topic. The key is the topic's name on DDS, such as
  /// "rt/io/state"; topics of DDS itself are left out.
  using Topics = std::map<std::string, Ends>;

  explicit Graph(Participant& participant);
  ~Graph();
  /// Returns the topics as they are now. A process whose name is not known yet appears under its
  /// GUID.
  [[nodiscard]] Topics topics();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace galilean::wire
