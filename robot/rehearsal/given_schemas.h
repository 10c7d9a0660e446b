#pragma once

#include "core/catalog/registry.h"
#include "core/schema/schema.h"

namespace galilean::robot {

/// A step `given:` as a perceptual schema: what it says is so between two times.
///
///   writes  bits_variable: bit `bit_index` is `bit_value`, or the whole is invalid
class GivenBits final : public PerceptualSchema {
 public:
  static void describe(Declaration<GivenBits>& is);
  void run(const Tick& tick) override;

 private:
  Variable<Bits>* bits_ = nullptr;
  unsigned bit_index_ = 0;
  bool bit_value_ = true;
  bool valid_ = true;
  double from_s_ = 0;
  double until_s_ = 0;
};

/// The same of a place.
///
///   writes  locate_variable: its centre is at `position`, odom frame, or it is invalid
class GivenLocate final : public PerceptualSchema {
 public:
  static void describe(Declaration<GivenLocate>& is);
  void run(const Tick& tick) override;

 private:
  Variable<Locate>* locate_ = nullptr;
  Vec2 position_m_ = Vec2::Zero();
  bool valid_ = true;
  double from_s_ = 0;
  double until_s_ = 0;
};

inline constexpr const char* kGivenBits = "given_bits";
inline constexpr const char* kGivenLocate = "given_locate";

/// Besides the robot's own components; no program can name them.
void add_given_schemas(Registry& registry);

}  // namespace galilean::robot
