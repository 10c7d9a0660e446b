// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/world.h"

namespace galilean::sim {
namespace {

std::string numbered(const char* kind, std::size_t index) {
  return std::string(kind) + "_" + std::to_string(index + 1);
}

const char* kind_name(FurnitureKind kind) {
  switch (kind) {
    case FurnitureKind::kTable:
      return "table";
    case FurnitureKind::kDesk:
      return "desk";
    case FurnitureKind::kScreen:
      break;
  }
  return "screen";
}

}  // namespace

std::string World::name_of(BodyTag tag) const {
  const std::size_t fixed = scenario_.furniture.size();
  switch (tag.kind) {
    case BodyKind::kRobot:
      return robot_name(tag.index);
    case BodyKind::kPiece:
      return numbered(to_string(objects_.pieces()[tag.index].kind), tag.index);
    case BodyKind::kBasket:
      return numbered("basket", tag.index);
    case BodyKind::kFurniture:
      return tag.index < fixed ? numbered(kind_name(scenario_.furniture[tag.index].kind), tag.index)
                               : numbered("chair", tag.index - fixed);
    case BodyKind::kWall:
      break;
  }
  return "a wall";
}

b2Body* World::find_body(std::string_view name) const {
  for (const b2Body* body = physics_.world().GetBodyList(); body; body = body->GetNext())
    if (body->GetType() == b2_dynamicBody && name_of(tag_of(*body)) == name)
      return const_cast<b2Body*>(body);
  return nullptr;
}

}  // namespace galilean::sim
