// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/navigation.h"

#include "bhdl/lsp/documents/name_search.h"
#include "bhdl/syntax/loader.h"

namespace galilean::bhdl::lsp {
namespace {

Json included_file(const Session& session, const ParsedFile& file, std::size_t offset) {
  for (const auto& node : file.tree()) {
    const auto* include = std::get_if<IncludeNode>(&node);
    if (include == nullptr || !file.index.range_of(include->path.text).touches(offset)) continue;
    const auto target = session.workspace.file(included_path(file.path, include->path.text));
    if (target != nullptr) return session.location(*target, {});
  }
  return nullptr;
}

}  // namespace

Json definition(const Session& session, const Json& params) {
  const FilePointer file = session.file(params);
  const std::size_t offset = session.offset(*file, params);
  const auto name = name_at(session.workspace, *file, offset);
  if (!name) return included_file(session, *file, offset);
  Json locations = Json::array();
  for (const auto& each : declarations(session.workspace, file->path, name->name))
    locations.push_back(session.location(*each.file, each.range));
  return locations;
}

Json references(const Session& session, const Json& params) {
  const FilePointer file = session.file(params);
  const bool with_declaration = is_true(params, Json::json_pointer("/context/includeDeclaration"));
  const auto name = name_at(session.workspace, *file, session.offset(*file, params));
  if (!name) return nullptr;
  Json locations = Json::array();
  for (const auto& each : occurrences(session.workspace, file->path, name->name))
    if (with_declaration || !each.declares)
      locations.push_back(session.location(*each.file, each.range));
  return locations;
}

}  // namespace galilean::bhdl::lsp
