// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bhdl/lsp/editor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bhdl/lsp/documents/uri.h"

namespace galilean::bhdl::lsp {
namespace {

std::string place_in_words(const Json& at) {
  return at["line"].dump() + ":" + at["character"].dump();
}

}  // namespace

Result<std::string, ReadFailure> MemoryFolder::read(const std::string& path, std::size_t) const {
  const auto found = files_.find(path);
  if (found == files_.end()) return ReadFailure{"file/not-found", "no file " + path};
  return found->second;
}

std::vector<std::string> MemoryFolder::beside(const std::string&) const {
  std::vector<std::string> paths;
  for (const auto& file : files_) paths.push_back(file.first);
  return paths;
}

Marked marked(std::string text) {
  const auto at = text.find('|');
  if (at == std::string::npos) return {std::move(text), {}};
  text.erase(at, 1);
  const TextIndex index(text);
  return {text, index.position(at, PositionEncoding::kUtf16)};
}

Editor::Editor(Files files, Json capabilities, const Catalog& catalog)
    : server_(catalog, std::make_unique<MemoryFolder>(std::move(files))) {
  const Json answer = send({{"jsonrpc", "2.0"},
                            {"id", 0},
                            {"method", "initialize"},
                            {"params", {{"capabilities", std::move(capabilities)}}}});
  initialized_ = answer["result"];
}

void Editor::open(const std::string& name, const std::string& text) {
  const Marked with_cursor = marked(text);
  uri_ = uri_of("/" + name);
  cursor_ = with_cursor.cursor;
  notify("textDocument/didOpen",
         {{"textDocument",
           {{"uri", uri_}, {"languageId", "bhdl"}, {"version", 1}, {"text", with_cursor.text}}}});
}

void Editor::change(const std::string& name, const Json& changes) {
  notify("textDocument/didChange", {{"textDocument", {{"uri", uri_of("/" + name)}, {"version", 2}}},
                                    {"contentChanges", changes}});
}

void Editor::close(const std::string& name) {
  notify("textDocument/didClose", {{"textDocument", {{"uri", uri_of("/" + name)}}}});
}

Json Editor::send(const Json& message) {
  Json answer;
  for (const auto& text : server_.receive(message.dump())) {
    const Json each = Json::parse(text);
    if (each.contains("id")) answer = each;
    take({text});
  }
  return answer;
}

void Editor::notify(const std::string& method, const Json& params) {
  take(server_.receive(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}.dump()));
}

void Editor::take(const std::vector<std::string>& messages) {
  for (const auto& text : messages) {
    Json message = Json::parse(text);
    if (message.value("method", "") == "textDocument/publishDiagnostics")
      published_[message["params"]["uri"]] = message["params"];
  }
}

Json Editor::ask(const std::string& method, const Json& more) {
  Json params{{"textDocument", {{"uri", uri_}}},
              {"position", {{"line", cursor_.line}, {"character", cursor_.character}}}};
  params.update(more);
  const Json answer =
      send({{"jsonrpc", "2.0"}, {"id", next_id_++}, {"method", method}, {"params", params}});
  EXPECT_FALSE(answer.contains("error")) << answer.dump(1);
  return answer.value("result", Json());
}

std::string Editor::refusal(const std::string& method, const Json& more) {
  Json params{{"textDocument", {{"uri", uri_}}},
              {"position", {{"line", cursor_.line}, {"character", cursor_.character}}}};
  params.update(more);
  const Json answer =
      send({{"jsonrpc", "2.0"}, {"id", next_id_++}, {"method", method}, {"params", params}});
  return answer.contains("error") ? answer["error"]["message"].get<std::string>() : "";
}

Json Editor::published(const std::string& name) {
  while (server_.has_work()) take(server_.work());
  return published_[uri_of("/" + name)];
}

std::string Editor::problems(const std::string& name) {
  std::string text;
  const Json params = published(name);
  for (const auto& each : params.value("diagnostics", Json::array()))
    text += place_in_words(each["range"]["start"]) + "-" + place_in_words(each["range"]["end"]) +
            " " + each["code"].get<std::string>() + "\n";
  return text;
}

std::vector<std::string> Editor::completions() {
  std::vector<std::string> labels;
  const Json answer = ask("textDocument/completion");
  for (const auto& item : answer.value("items", Json::array())) labels.push_back(item["label"]);
  return labels;
}

std::string edited(const std::string& text, const Json& edits) {
  const TextIndex index(text);
  std::string result = text;
  const auto at = [&](const Json& position) {
    return index.offset({position["line"], position["character"]}, PositionEncoding::kUtf16);
  };
  for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
    const auto begin = at((*edit)["range"]["start"]);
    result.replace(begin, at((*edit)["range"]["end"]) - begin,
                   (*edit)["newText"].get<std::string>());
  }
  return result;
}

}  // namespace galilean::bhdl::lsp
