// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "monitor/ingest/channel.h"
#include "monitor/pushes/push_requests.h"
#include "monitor/team/team.h"
#include "monitor/trial/trial.h"

namespace galilean::monitor {

/// Tries programs in simulators that start from the live team's situation.
class TrialRoom {
 public:
  /// `simulator` is the path of galilean-sim. The simulators' files go into `folder`.
  TrialRoom(boost::asio::io_context& io, const Team& team, std::filesystem::path simulator,
            std::filesystem::path folder)
      : io_(io), team_(team), simulator_(std::move(simulator)), folder_(std::move(folder)) {}

  /// Takes in any message, and keeps the newest map.
  void receive(const Message& message);
  /// Begins to try the program beside the one that the robots run now. `id` is the push's. Errors:
  /// the simulator, the team's situation or the scenario is missing.
  [[nodiscard]] Result<std::unique_ptr<Trial>> begin(const std::string& id, const TryProgram& what,
                                                     Trial::Done done) const;

 private:
  [[nodiscard]] std::optional<msg::ObjectMap> map() const;
  [[nodiscard]] std::vector<bhdl::SourceFile> running(const std::vector<std::string>& robots) const;

  boost::asio::io_context& io_;
  const Team& team_;
  std::filesystem::path simulator_, folder_;
  Payload newest_map_;
};

}  // namespace galilean::monitor
