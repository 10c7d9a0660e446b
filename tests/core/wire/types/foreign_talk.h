// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/wire/delivery.h"
#include "core/wire/entity.h"

struct dds_topic_descriptor;

namespace galilean::wire {

/// The messages of types that Galilean does not define. There is one sample of each.
enum class Foreign {
  kPlain,
  kReport,
  kSettings,
  kKeyed,
  kLarge,  ///< 200 kB
  kCells,
  kRobotState,  ///< named as the message of Galilean, and defined differently
  kBare         ///< without type information
};

[[nodiscard]] const dds_topic_descriptor& foreign_descriptor(Foreign message);
/// Returns the type's name on DDS.
[[nodiscard]] std::string foreign_type(Foreign message);

/// How a writer encodes its messages.
enum class Cdr { kFirst = 1, kSecond = 2 };

/// Writes the sample of a foreign message to a topic, in a partition unless that is empty.
/// Without a delivery it is reliable and keeps the newest for late joiners. Cyclone 0.10 may hold
/// back the newest message of a writer with a latency budget until the next one.
class ForeignTalk {
 public:
  /// Errors: throws std::runtime_error if Cyclone refuses it.
  ForeignTalk(std::int32_t participant, Foreign message, const std::string& topic, Cdr version,
              const std::string& partition = {}, Delivery delivery = Delivery::kState,
              std::chrono::nanoseconds latency_budget = {});
  /// Returns whether Cyclone took the sample.
  [[nodiscard]] bool write();
  /// Says that the key of the sample is no more.
  [[nodiscard]] bool dispose();
  [[nodiscard]] int readers() const;
  /// Waits until every reader has got all samples, for at most ten seconds. Returns whether they
  /// have.
  [[nodiscard]] bool arrived() const;

 private:
  Foreign message_;
  Entity topic_, writer_;
};

/// Joins a domain as another process would, which this process has joined by Participant: what
/// both say to each other goes over the network.
class ForeignProcess {
 public:
  ForeignProcess(const std::string& name, int domain);
  [[nodiscard]] std::int32_t participant() const noexcept { return participant_.handle(); }

 private:
  Entity domain_, participant_;
};

}  // namespace galilean::wire
