// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/result.h"
#include "core/termination.h"
#include "core/wake.h"
#include "core/wire/endpoints.h"
#include "core/wire/participant.h"
#include "monitor/wire/definitions.h"
#include "monitor/wire/topic_reader.h"

namespace galilean::monitor {

/// A short-lived command's look at the domain. For use by one thread.
class WireSession {
 public:
  /// `name` is what other processes see. Errors: the domain cannot be joined.
  [[nodiscard]] static Result<std::unique_ptr<WireSession>> join(
      int domain, const std::string& name = "topics");

  /// Returns the writers and readers, after a short wait in which they are discovered.
  [[nodiscard]] std::vector<wire::EndpointInfo> discover();
  /// Returns those that are known now.
  [[nodiscard]] std::vector<wire::EndpointInfo> known() { return endpoints_.known(); }
  /// Returns the topic, if it is known now. Errors: nobody writes or reads it.
  [[nodiscard]] Result<FoundTopic> find_now(const std::string& topic);
  /// As find_now, after a short wait in which the topic is discovered.
  [[nodiscard]] Result<FoundTopic> find(const std::string& topic);
  /// Requires: this outlives the reader.
  [[nodiscard]] std::unique_ptr<TopicReader> read(FoundTopic topic);
  /// Where an end's type is found. It lives as long as this.
  [[nodiscard]] Definitions& definitions() noexcept { return definitions_; }

  [[nodiscard]] wire::Participant& participant() noexcept { return *participant_; }
  /// Has `wait` look at once. Any thread may call it.
  void ring() noexcept { wake_.ring(); }

  /// Calls `enough` whenever messages may have come, until it returns true, `most` is over, or
  /// termination is asked for. Returns whether it returned true.
  bool wait(Duration most, const std::function<bool()>& enough);
  [[nodiscard]] bool ended() noexcept { return termination_.asked(); }
  [[nodiscard]] Time now() const noexcept { return clock_.now(); }

 private:
  explicit WireSession(std::unique_ptr<wire::Participant> participant,
                       std::unique_ptr<Termination> termination);

  SteadyClock clock_;
  std::unique_ptr<Termination> owned_termination_;
  Termination& termination_;
  Wake wake_;
  std::unique_ptr<wire::Participant> participant_;
  wire::Endpoints endpoints_;
  Definitions definitions_;
};

}  // namespace galilean::monitor
