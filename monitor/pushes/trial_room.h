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

/// Where programs are tried: clones the live team into simulators.
class TrialRoom {
 public:
  /// `simulator`: galilean-sim. `folder`: for what the simulators read and write.
  TrialRoom(boost::asio::io_context& io, const Team& team, std::filesystem::path simulator,
            std::filesystem::path folder)
      : io_(io), team_(team), simulator_(std::move(simulator)), folder_(std::move(folder)) {}

  /// Takes any message; keeps the newest map.
  void receive(const Message& message);
  /// Tries the program beside what the first of the robots runs now. `id`: of the push. Errors:
  /// what is missing.
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
