// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/ingest/ingest.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// Hears the team for a command that is over soon: joins DDS, and takes messages while it waits.
class TeamListener {
 public:
  /// `name` is what others are shown.
  [[nodiscard]] static Result<std::unique_ptr<TeamListener>> join(const std::string& name,
                                                                  int domain);

  /// Takes messages until `enough` or until `timeout` is over; false then.
  bool wait(Duration timeout, const std::function<bool()>& enough);
  /// Waits until the robots named are heard, or, where none is named, until no new one turns up any
  /// more. Each with its state and its catalog. What is missing at the end is the error.
  [[nodiscard]] Result<std::vector<const Robot*>> find(const std::vector<std::string>& names,
                                                       Duration timeout);
  void on_message(std::function<void(const Message&)> callback) { message_ = std::move(callback); }

  [[nodiscard]] wire::Participant& participant() noexcept { return *participant_; }
  [[nodiscard]] const Team& team() const noexcept { return team_; }
  [[nodiscard]] Time now() const noexcept { return clock_.now(); }

 private:
  explicit TeamListener(std::unique_ptr<wire::Participant> participant);
  [[nodiscard]] bool known(const std::string& robot) const;

  std::unique_ptr<wire::Participant> participant_;
  SteadyClock clock_;
  Team team_;
  std::function<void(const Message&)> message_;
  std::mutex mutex_;
  std::condition_variable woken_;
  bool pending_ = false;  ///< under `mutex_`
  Ingest ingest_;
};

}  // namespace galilean::monitor
