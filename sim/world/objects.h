#pragma once

#include <vector>

#include "core/random.h"
#include "core/result.h"
#include "sim/scenario.h"
#include "sim/world/physics.h"

namespace galilean::sim {

struct PieceShape {
  double radius_m;
  double height_m;
  double mass_kg;
};
[[nodiscard]] const PieceShape& shape_of(PieceKind kind) noexcept;

inline constexpr double kBasketRadius_m = 0.14;
inline constexpr double kBasketHeight_m = 0.30;

/// Where every piece lies at the start: the placed ones, then the strewn ones, drawn anew until
/// they keep the scenario's clearance. An error says that the arena has no room for them.
[[nodiscard]] Result<std::vector<PlacedPiece>> strew(const Scenario& scenario, Random random);

/// The bodies that can be pushed: pieces and baskets. They rub on the floor:
/// a body at speed v loses min(v, mu g dt) a step.
class Objects {
 public:
  Objects(const Scenario& scenario, const std::vector<PlacedPiece>& pieces, Physics& physics);

  struct Piece {
    PieceKind kind = PieceKind::kCan;
    b2Body* body = nullptr;  ///< null once it is thrown away
  };
  [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }
  [[nodiscard]] const std::vector<b2Body*>& baskets() const noexcept { return baskets_; }

  void rub(double dt_s);
  /// Takes a piece out of the arena.
  void remove_piece(std::size_t index);

 private:
  Physics& physics_;
  std::vector<Piece> pieces_;
  std::vector<b2Body*> baskets_;
};

}  // namespace galilean::sim
