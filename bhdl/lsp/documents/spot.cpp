// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/spot.h"

namespace galilean::bhdl::lsp {
namespace {

std::optional<Spot> spot_in(const Entity& entity, const TextIndex& index, std::size_t offset) {
  Spot spot{.component = entity.spec, .attribute = {}, .value = {}, .given = &entity.attributes};
  spot.range = index.range_of(entity.type.text);
  if (spot.range.touches(offset)) return spot;
  for (const auto& attribute : entity.attributes) {
    spot.attribute = entity.spec->find(attribute.name.text);
    if (spot.attribute == nullptr) continue;
    spot.range = index.range_of(attribute.name.text);
    if (spot.range.touches(offset)) return spot;
    for (const auto& value : attribute.values) {
      spot.range = index.range_of(value.text);
      spot.value = &value;
      if (spot.range.touches(offset)) return spot;
    }
    spot.value = nullptr;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Spot> spot_at(const ParsedFile& file, const Vocabulary& vocabulary,
                            std::size_t offset) {
  std::optional<Spot> found;
  for_each_entity(file.tree(), vocabulary, [&](const Entity& entity) {
    if (!found && entity.spec != nullptr) found = spot_in(entity, file.index, offset);
  });
  return found;
}

}  // namespace galilean::bhdl::lsp
