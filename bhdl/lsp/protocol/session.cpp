// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/protocol/session.h"

#include "bhdl/lsp/documents/uri.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl::lsp {
namespace {

using Pointer = Json::json_pointer;

PositionEncoding chosen_encoding(const Json& params) {
  const Json* offered = find_in(params, Pointer("/capabilities/general/positionEncodings"));
  if (offered == nullptr || !offered->is_array()) return PositionEncoding::kUtf16;
  for (const auto& name : *offered)
    if (const auto found =
            name.is_string() ? find_encoding(name.get_ref<const std::string&>()) : std::nullopt)
      return *found;
  return PositionEncoding::kUtf16;
}

bool lists(const Json& params, const Pointer& path, std::string_view word) {
  const Json* list = find_in(params, path);
  if (list == nullptr || !list->is_array()) return false;
  return std::ranges::any_of(*list, [&](const Json& each) { return each == word; });
}

Json position_to_json(TextPosition at) {
  return {{"line", at.line}, {"character", at.character}};
}

std::size_t count_from(const Json& json) {
  if (!json.is_number_integer() || json.get<std::int64_t>() < 0)
    throw Refusal(RpcError::kInvalidParams, "a position's line and character count from 0");
  return json.get<std::size_t>();
}

}  // namespace

Client read_client(const Json& params) {
  const auto can = [&](const char* path) { return is_true(params, Pointer(path)); };
  const std::string item = "/capabilities/textDocument/completion/completionItem";
  return {.encoding = chosen_encoding(params),
          .snippets = can((item + "/snippetSupport").c_str()),
          .markdown =
              lists(params, Pointer("/capabilities/textDocument/hover/contentFormat"), "markdown"),
          .completion_defaults = lists(
              params, Pointer("/capabilities/textDocument/completion/completionList/itemDefaults"),
              "editRange"),
          .document_changes = can("/capabilities/workspace/workspaceEdit/documentChanges"),
          .symbol_trees =
              can("/capabilities/textDocument/documentSymbol/hierarchicalDocumentSymbolSupport"),
          .related_information =
              can("/capabilities/textDocument/publishDiagnostics/relatedInformation")};
}

TextPosition position_from(const Json& json) {
  return {count_from(json.at("line")), count_from(json.at("character"))};
}

FilePointer Session::file(const Json& params) const {
  const auto uri = params.at("textDocument").at("uri").get<std::string>();
  if (auto found = workspace.file(path_of(uri))) return found;
  throw Refusal(RpcError::kRequestFailed,
                in_quotes(uri) + " is not open, and cannot be read as a BHDL file");
}

std::size_t Session::offset(const ParsedFile& file, const Json& params) const {
  return file.index.offset(position_from(params.at("position")), client.encoding);
}

Json Session::range(const ParsedFile& file, ByteRange bytes) const {
  return {{"start", position_to_json(file.index.position(bytes.begin, client.encoding))},
          {"end", position_to_json(file.index.position(bytes.end, client.encoding))}};
}

ByteRange Session::bytes(const ParsedFile& file, const Json& range) const {
  return {file.index.offset(position_from(range.at("start")), client.encoding),
          file.index.offset(position_from(range.at("end")), client.encoding)};
}

Json Session::location(const ParsedFile& file, ByteRange bytes) const {
  return {{"uri", workspace.uri(file.path)}, {"range", range(file, bytes)}};
}

Json workspace_edit(const Session& session, const std::map<std::string, Json>& edits_of_path) {
  Json changes = Json::object();
  Json document_changes = Json::array();
  for (const auto& [path, edits] : edits_of_path) {
    const std::string uri = session.workspace.uri(path);
    changes[uri] = edits;
    const Workspace::Document* open = session.workspace.find_open(path);
    document_changes.push_back(
        {{"textDocument",
          {{"uri", uri}, {"version", open == nullptr ? Json() : Json(open->version)}}},
         {"edits", edits}});
  }
  if (session.client.document_changes) return {{"documentChanges", document_changes}};
  return {{"changes", changes}};
}

}  // namespace galilean::bhdl::lsp
