// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/server.h"

#include <algorithm>
#include <array>

#include "bhdl/lsp/features/completion.h"
#include "bhdl/lsp/features/document_symbols.h"
#include "bhdl/lsp/features/document_sync.h"
#include "bhdl/lsp/features/formatting.h"
#include "bhdl/lsp/features/hover.h"
#include "bhdl/lsp/features/navigation.h"
#include "bhdl/lsp/features/quick_fix.h"
#include "bhdl/lsp/features/rename.h"
#include "bhdl/source/text.h"
#include "core/json_text.h"

namespace galilean::bhdl::lsp {
namespace {

struct Feature {
  std::string_view method;
  Json (*answer)(const Session& session, const Json& params);
};
constexpr std::array<Feature, 9> kFeatures{{{"textDocument/completion", completion},
                                            {"textDocument/hover", hover},
                                            {"textDocument/definition", definition},
                                            {"textDocument/references", references},
                                            {"textDocument/prepareRename", prepare_rename},
                                            {"textDocument/rename", rename},
                                            {"textDocument/documentSymbol", document_symbols},
                                            {"textDocument/foldingRange", folding_ranges},
                                            {"textDocument/formatting", formatting}}};

constexpr std::string_view kCodeAction = "textDocument/codeAction";

Json capabilities(const Client& client) {
  constexpr int kIncremental = 2;
  return {{"positionEncoding", to_string(client.encoding)},
          {"textDocumentSync", {{"openClose", true}, {"change", kIncremental}}},
          {"completionProvider", {{"triggerCharacters", {"\""}}}},
          {"hoverProvider", true},
          {"definitionProvider", true},
          {"referencesProvider", true},
          {"renameProvider", {{"prepareProvider", true}}},
          {"documentSymbolProvider", true},
          {"foldingRangeProvider", true},
          {"documentFormattingProvider", true},
          {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}}};
}

bool is_request(const Json& message) {
  return message.contains("id");
}

bool is_id(const Json& id) {
  return id.is_string() || id.is_number();
}

/// Returns why this is no JSON-RPC 2.0 message, or nullptr if it is one.
const char* objection(const Json& message) {
  if (!message.is_object()) return "a message is one JSON object; there are no batches here";
  if (message.value("jsonrpc", Json()) != "2.0") return "a message has \"jsonrpc\": \"2.0\"";
  if (is_request(message) && !is_id(message["id"])) return "an id is a number or a string";
  if (!message.value("method", Json()).is_string()) return "a message has a \"method\"";
  const Json params = message.value("params", Json::object());
  return params.is_object() || params.is_null() || params.is_array() ? nullptr
                                                                     : "\"params\" is an object";
}

bool is_response(const Json& message) {
  return message.is_object() && !message.contains("method") &&
         (message.contains("result") || message.contains("error"));
}

Json log_message(const std::string& text) {
  constexpr int kErrorType = 1;
  return rpc_notification("window/logMessage", {{"type", kErrorType}, {"message", text}});
}

/// Returns the answer that `work` gives. If `work` throws, returns the answer that says why.
template <class Work>
std::optional<Json> guarded(const Json& message, Work work) {
  const auto failed = [&](RpcError code, const std::string& text) -> std::optional<Json> {
    if (is_request(message)) return rpc_error(message["id"], code, text);
    return log_message(text);
  };
  try {
    return work();
  } catch (const Refusal& refusal) {
    return failed(refusal.code(), refusal.what());
  } catch (const Json::exception& problem) {
    return failed(RpcError::kInvalidParams, problem.what());
  } catch (const std::exception& problem) {
    return failed(RpcError::kInternal, problem.what());
  }
}

}  // namespace

Server::Server(const Catalog& catalog, std::unique_ptr<ProgramFolder> folder)
    : vocabulary_(catalog), folder_(std::move(folder)), workspace_(*folder_, vocabulary_) {}

std::vector<std::string> Server::receive(std::string_view text) {
  std::vector<std::string> out;
  const auto read = read_untrusted_json(text);
  if (!read) return {dumped(rpc_error(nullptr, RpcError::kParse, read.error().message))};
  const Json& message = read.value();
  if (is_response(message)) return out;
  if (const char* why = objection(message)) {
    const bool has_id = message.is_object() && is_request(message) && is_id(message["id"]);
    return {dumped(rpc_error(has_id ? message["id"] : Json(), RpcError::kInvalidRequest, why))};
  }
  const auto reply = guarded(message, [&] { return answer(message, out); });
  if (reply) out.push_back(dumped(*reply));
  return out;
}

std::optional<Json> Server::answer(const Json& message, std::vector<std::string>& before) {
  const auto& method = message["method"].get_ref<const std::string&>();
  const Json params = message.value("params", Json::object());
  if (is_request(message)) return rpc_result(message["id"], request(method, params, before));
  notice(method, params);
  return std::nullopt;
}

Json Server::request(std::string_view method, const Json& params,
                     std::vector<std::string>& before) {
  if (phase_ == Phase::kShutDown)
    throw Refusal(RpcError::kInvalidRequest, "the server was told to shut down");
  if (method == "initialize") return initialize(params);
  if (phase_ == Phase::kNew)
    throw Refusal(RpcError::kNotInitialized, "the first request is \"initialize\"");
  if (method == "shutdown") {
    phase_ = Phase::kShutDown;
    return nullptr;
  }
  if (method == kCodeAction) {
    if (publisher_.due()) before = work();
    return quick_fixes(session(), publisher_, params);
  }
  const auto* feature = std::ranges::find(kFeatures, method, &Feature::method);
  if (feature == kFeatures.end())
    throw Refusal(RpcError::kUnknownMethod, "there is no method " + in_quotes(method));
  return feature->answer(session(), params);
}

void Server::notice(std::string_view method, const Json& params) {
  if (method == "exit") exit_status_ = phase_ == Phase::kShutDown ? 0 : 1;
  if (phase_ != Phase::kReady) return;
  const auto sync = [&](void (*take)(const Session&, const Json&)) {
    take(session(), params);
    publisher_.note_change();
  };
  if (method == "textDocument/didOpen") return sync(did_open);
  if (method == "textDocument/didChange") return sync(did_change);
  if (method == "textDocument/didClose") return sync(did_close);
  if (method == "workspace/didChangeWatchedFiles") publisher_.note_change();
}

Json Server::initialize(const Json& params) {
  if (phase_ != Phase::kNew)
    throw Refusal(RpcError::kInvalidRequest, "the server was initialized before");
  client_ = read_client(params);
  phase_ = Phase::kReady;
  return {{"capabilities", capabilities(client_)}, {"serverInfo", {{"name", "galilean bhdl"}}}};
}

std::vector<std::string> Server::work() {
  std::vector<std::string> out;
  for (const auto& notification : publisher_.publish(session()))
    out.push_back(dumped(notification));
  return out;
}

}  // namespace galilean::bhdl::lsp
