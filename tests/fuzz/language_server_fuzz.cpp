// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "bhdl/lsp/server.h"
#include "tests/bhdl/small_catalog.h"
#include "tests/fuzz/input.h"

// An input that begins with a brace is sent as a message. Any other input is a text. The editor
// opens it, sends every request about a place that the text itself determines, cuts the text there,
// and sends them again.

using namespace galilean::bhdl;
using namespace galilean::bhdl::lsp;

namespace {

constexpr const char* kUri = "file:///0";

class NoFolder : public ProgramFolder {
 public:
  [[nodiscard]] galilean::Result<std::string, ReadFailure> read(const std::string&,
                                                                std::size_t) const override {
    return ReadFailure{"file/not-found", "no such file"};
  }
  [[nodiscard]] std::vector<std::string> beside(const std::string&) const override { return {}; }
};

class FuzzingClient {
 public:
  FuzzingClient() : server_(small_catalog(), std::make_unique<NoFolder>()) {
    ask("initialize", {{"capabilities", Json::object()}});
  }

  std::vector<Json> send(std::string_view message) {
    std::vector<Json> answers;
    for (const auto& answer : server_.receive(message)) answers.push_back(Json::parse(answer));
    return answers;
  }
  void notify(const char* method, const Json& params) {
    send(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}.dump());
  }
  void ask(const char* method, const Json& params) {
    const auto answers =
        send(Json{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", params}}.dump());
    must(!answers.empty() && answers.back().contains("id"), "every request has an answer");
  }
  void check() {
    while (server_.has_work())
      for (const auto& published : server_.work()) must(Json::accept(published), "JSON goes out");
  }

 private:
  Server server_;
};

/// Returns a place in the text, or behind its last line.
Json place_in(std::string_view text) {
  std::size_t hash = text.size();
  for (const char each : text) hash = hash * 31 + static_cast<unsigned char>(each);
  const std::size_t at = hash % (text.size() + 1);
  const auto before = text.substr(0, at);
  const auto line_begin = before.rfind('\n');
  return {{"line", std::ranges::count(before, '\n')},
          {"character", line_begin == std::string_view::npos ? at : at - line_begin - 1}};
}

void ask_everything(FuzzingClient& client, const Json& place) {
  const Json document{{"uri", kUri}};
  const Json range{{"start", {{"line", 0}, {"character", 0}}}, {"end", place}};
  const Json params{{"textDocument", document},
                    {"position", place},
                    {"range", range},
                    {"newName", "other"},
                    {"options", {{"tabSize", 2}, {"insertSpaces", true}}},
                    {"context", {{"includeDeclaration", true}, {"diagnostics", Json::array()}}}};
  constexpr std::array kMethods{
      "completion", "hover",        "definition", "references",     "prepareRename",    "rename",
      "formatting", "foldingRange", "codeAction", "documentSymbol", "documentHighlight"};
  for (const auto* method : kMethods)
    client.ask((std::string("textDocument/") + method).c_str(), params);
  client.check();
}

void edit(FuzzingClient& client, const std::string& text) {
  const Json place = place_in(text);
  client.notify(
      "textDocument/didOpen",
      {{"textDocument", {{"uri", kUri}, {"languageId", "bhdl"}, {"version", 1}, {"text", text}}}});
  ask_everything(client, place);
  const Json cut{{"range", {{"start", {{"line", 0}, {"character", 0}}}, {"end", place}}},
                 {"text", ""}};
  client.notify("textDocument/didChange", {{"textDocument", {{"uri", kUri}, {"version", 2}}},
                                           {"contentChanges", Json::array({cut})}});
  ask_everything(client, {{"line", 0}, {"character", 1}});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(reinterpret_cast<const char*>(data), size);
  FuzzingClient client;
  if (input.starts_with('{')) {
    client.send(input);
    return 0;
  }
  // The text goes through JSON, because only UTF-8 can come over the wire.
  const auto sent = Json(input).dump(-1, ' ', false, Json::error_handler_t::replace);
  edit(client, Json::parse(sent).get<std::string>());
  return 0;
}
