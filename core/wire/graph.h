// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "core/wire/participant.h"

namespace galilean::wire {

/// Who writes and who reads what in the domain, by the names that processes joined it with.
class Graph {
 public:
  struct Ends {
    std::set<std::string> writers, readers;
    bool operator==(const Ends&) const = default;
  };
  /// By topic, as on DDS: "rt/io/state". Topics of DDS itself are left out.
  using Topics = std::map<std::string, Ends>;

  explicit Graph(Participant& participant);
  ~Graph();
  /// As it is now. A process that is not known by name yet is called by its GUID.
  [[nodiscard]] Topics topics();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace galilean::wire
