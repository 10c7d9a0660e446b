// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/document_sync.h"

#include "bhdl/lsp/documents/uri.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl::lsp {
namespace {

void apply_change(std::string& text, const Json& change, PositionEncoding encoding) {
  const auto& put_in = change.at("text").get_ref<const std::string&>();
  if (!change.contains("range")) {
    text = put_in;
    return;
  }
  const TextIndex index(text);
  const std::size_t begin = index.offset(position_from(change.at("range").at("start")), encoding);
  const std::size_t end = index.offset(position_from(change.at("range").at("end")), encoding);
  if (end < begin) throw Refusal(RpcError::kInvalidParams, "a change ends before it begins");
  text.replace(begin, end - begin, put_in);
}

/// Requires: the document at `path` would have `bytes`.
void refuse_too_large(const Session& session, const std::string& path, std::size_t bytes) {
  std::size_t all = bytes;
  for (const auto& [other, document] : session.workspace.open_documents())
    if (other != path) all += document.text.size();
  if (all > kMostOpenBytes)
    throw Refusal(RpcError::kInvalidParams,
                  "with " + in_quotes(path) + " all open documents have more than 16 MiB");
}

}  // namespace

void did_open(const Session& session, const Json& params) {
  const Json& document = params.at("textDocument");
  auto uri = document.at("uri").get<std::string>();
  const std::string path = path_of(uri);
  const bool is_new = session.workspace.find_open(path) == nullptr;
  if (is_new && session.workspace.open_documents().size() >= kMostDocuments)
    throw Refusal(RpcError::kInvalidParams, "no more than 256 documents can be open");
  auto text = document.at("text").get<std::string>();
  refuse_too_large(session, path, text.size());
  session.workspace.open(
      path, {std::move(uri), document.value("version", std::int64_t{0}), std::move(text)});
}

void did_change(const Session& session, const Json& params) {
  const Json& named = params.at("textDocument");
  const auto uri = named.at("uri").get<std::string>();
  const std::string path = path_of(uri);
  Workspace::Document* document = session.workspace.find_open(path);
  if (document == nullptr)
    throw Refusal(RpcError::kInvalidParams, in_quotes(uri) + " was changed but is not open");
  std::string text = document->text;
  for (const auto& change : params.at("contentChanges")) {
    apply_change(text, change, session.client.encoding);
    refuse_too_large(session, path, text.size());
  }
  document->text = std::move(text);
  document->version = named.value("version", document->version);
}

void did_close(const Session& session, const Json& params) {
  session.workspace.close(path_of(params.at("textDocument").at("uri").get<std::string>()));
}

}  // namespace galilean::bhdl::lsp
