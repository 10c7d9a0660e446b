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

/// A short-lived command's view of the team. It joins DDS, and takes messages only during `wait`
/// and `find`.
class TeamListener {
 public:
  /// `name` is the participant's name, which other participants see.
  /// `hears` says which topics are read: without it, the states, the catalogs, the answers to
  /// pushes, and which robots a monitor knows. Errors: DDS cannot be used.
  [[nodiscard]] static Result<std::unique_ptr<TeamListener>> join(
      const std::string& name, int domain, Ingest::ReadAtOnce hears = is_heard_by_pushers);

  /// Takes messages until `enough` returns true or `timeout` is over. Returns the last result of
  /// `enough`.
  bool wait(Duration timeout, const std::function<bool()>& enough);
  /// Returns the robots of these names, or all that are known if there are no names, of which some
  /// may send no state. Waits, at most
  /// `timeout`, for the state and the catalog of each named robot, or until no new robot has been
  /// heard for 0.5 s.
  /// Errors: no robot is heard, or a named one is not.
  [[nodiscard]] Result<std::vector<const Robot*>> find(const std::vector<std::string>& names,
                                                       Duration timeout);
  void on_message(std::function<void(const Message&)> callback) { message_ = std::move(callback); }

  [[nodiscard]] wire::Participant& participant() noexcept { return *participant_; }
  [[nodiscard]] const Team& team() const noexcept { return team_; }
  [[nodiscard]] Time now() const noexcept { return clock_.now(); }

 private:
  TeamListener(std::unique_ptr<wire::Participant> participant, Ingest::ReadAtOnce hears);
  [[nodiscard]] static bool is_heard_by_pushers(const Channel& channel);
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
