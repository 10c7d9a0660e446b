// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/random.h"
#include "core/result.h"
#include "sim/scenario/scenario.h"
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

inline constexpr double kChairLegRadius_m = 0.015;
/// Returns where the legs of a chair stand, in its own frame.
[[nodiscard]] std::array<Vec2, 4> chair_legs_m(double pitch_m) noexcept;

/// Returns where every piece lies at the start: first the placed ones, then the strewn ones. A
/// strewn place is drawn again until it keeps the scenario's clearance. Errors: the arena has no
/// room for the pieces.
[[nodiscard]] Result<std::vector<PlacedPiece>> scatter_pieces(const Scenario& scenario,
                                                              Random random);

/// The bodies that can be pushed: pieces, baskets and chairs. They rub on the floor:
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
  /// Returns the chairs in the order of the scenario.
  [[nodiscard]] const std::vector<b2Body*>& chairs() const noexcept { return chairs_; }

  void rub(double dt_s);
  /// Takes a piece out of the arena.
  void remove_piece(std::size_t index);
  /// Adds a piece and returns its number.
  std::size_t add_piece(const PlacedPiece& piece);
  /// Puts everything back to where it was at first. Pieces that were added since then are removed.
  void reset();

 private:
  void add_chair(const Chair& chair, std::uint16_t number);
  [[nodiscard]] b2Body& make_piece(const PlacedPiece& piece, std::size_t index);

  Physics& physics_;
  std::vector<PlacedPiece> first_pieces_;
  std::vector<Vec2> first_baskets_m_;
  std::vector<Pose2> first_chairs_;
  std::vector<Piece> pieces_;
  std::vector<b2Body*> baskets_;
  std::vector<b2Body*> chairs_;
};

}  // namespace galilean::sim
