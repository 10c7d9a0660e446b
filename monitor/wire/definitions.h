// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>

#include "core/clock.h"
#include "core/result.h"
#include "core/wire/endpoints.h"
#include "core/wire/participant.h"
#include "core/wire/types/type_finder.h"

namespace galilean::monitor {

/// Whose definition of its type an endpoint has.
enum class Definition {
  kOurs,        ///< that of this release
  kOther,       ///< its own, of a type that this release defines differently
  kOwn,         ///< its own, of a type that this release does not define
  kUnpublished  ///< unknown: it publishes no type information
};
[[nodiscard]] Definition definition_of(const wire::EndpointInfo& end);
/// Returns the word for it in JSON, such as "ours".
[[nodiscard]] std::string definition_word(Definition definition);

/// Finds the types of writers and readers: among those of this release, or by asking them.
class Definitions {
 public:
  /// It gives up an answer when `ended` returns true, and after 3 s. It then looks for it again,
  /// but briefly and not oftener than once a second. Requires: the participant outlives this.
  Definitions(const wire::Participant& participant, std::function<bool()> ended)
      : finder_(participant), ended_(std::move(ended)) {}

  /// Returns the type of what the endpoint writes or reads. One without type information is taken
  /// to have this release's definition of a type of that name. It may block.
  /// Errors: there is no definition, or it cannot be decoded. The error is a sentence.
  [[nodiscard]] Result<wire::Type> find(const wire::EndpointInfo& end);

 private:
  struct Failure {
    std::string clause;
    Time asked{};
  };

  SteadyClock clock_;
  wire::TypeFinder finder_;
  std::function<bool()> ended_;
  std::map<std::string, Failure> failures_;  ///< by hash
};

}  // namespace galilean::monitor
