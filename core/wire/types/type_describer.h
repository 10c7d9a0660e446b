// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <stdexcept>
#include <utility>

#include "core/wire/types/describe_type.h"
#include "core/wire/unwrapped.h"

namespace galilean::wire {

/// Why a type cannot be described, as a clause.
struct Indescribable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Describes one type and those that it is made of. Errors: throws Indescribable.
class TypeDescriber {
 public:
  explicit TypeDescriber(const FindTypeObject& find) : find_(find) {}

  /// Where a type is used.
  struct Place {
    int depth = 0;
    bool in_ros_type = false;
    [[nodiscard]] Place inside() const { return {depth + 1, in_ros_type}; }
  };
  [[nodiscard]] Type describe(const DDS_XTypes_TypeIdentifier& id, Place place);

 private:
  /// A type that was described before, and how many levels of types are within it.
  struct Known {
    Type type;
    int levels = 0;
  };

  /// Notes that the description goes down to this depth. Errors: throws Indescribable if that is
  /// deeper than the decoder, which calls itself for each level, shall go.
  void reach(int depth);
  Type named(const DDS_XTypes_TypeIdentifier& id, Place place);
  Type defined(const DDS_XTypes_CompleteTypeObject& object, Place place);
  Type sequence(const DDS_XTypes_TypeIdentifier* element, std::uint32_t bound, Place place);
  Type array(const DDS_XTypes_TypeIdentifier* element, std::vector<std::uint32_t> bounds,
             Place place);
  Type structure(const DDS_XTypes_CompleteStructType& object, Place place);
  Type choice(const DDS_XTypes_CompleteUnionType& object, Place place);

  const FindTypeObject& find_;
  std::map<std::pair<std::string, bool>, Known> known_;  ///< by hash and whether in a ROS 2 type
  int deepest_ = 0;  ///< the depth that the named type in hand reaches so far
};

}  // namespace galilean::wire
