// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// The attributes of every variable besides its name.
struct ReliabilitySettings {
  bool valid = false;
  double certainty = 1;
  double memory_s = 60;

  /// Returns the reliability that the variable has when the program starts.
  [[nodiscard]] Reliability reliability() const noexcept;
};

struct ShaftSettings : ReliabilitySettings {
  Vec2 position_m = Vec2::Zero();
  double heading_rad = 0;

  static void describe(Declaration<ShaftSettings>& is);
  [[nodiscard]] Shaft content() const noexcept;
};

struct ImageSettings : ReliabilitySettings {
  static void describe(Declaration<ImageSettings>& is);
};

struct LocateSettings : ReliabilitySettings {
  ObjectClass object = ObjectClass::kUnknown;
  Vec2 position_m = Vec2::Zero();
  double radius_m = 0;

  static void describe(Declaration<LocateSettings>& is);
  [[nodiscard]] Locate content() const noexcept;
};

struct BitsSettings : ReliabilitySettings {
  std::uint32_t value = 0;

  static void describe(Declaration<BitsSettings>& is);
  [[nodiscard]] Bits content() const noexcept;
};

struct ForceSettings : ReliabilitySettings {
  Vec2 value = Vec2::Zero();

  static void describe(Declaration<ForceSettings>& is);
  [[nodiscard]] Force content() const noexcept;
};

}  // namespace galilean::robot
