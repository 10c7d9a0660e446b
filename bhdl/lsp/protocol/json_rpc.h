// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace galilean::bhdl::lsp {

using Json = nlohmann::json;

/// Error codes of JSON-RPC and of the Language Server Protocol.
enum class RpcError {
  kParse = -32700,
  kInvalidRequest = -32600,
  kUnknownMethod = -32601,
  kInvalidParams = -32602,
  kInternal = -32603,
  kNotInitialized = -32002,
  kRequestFailed = -32803
};

/// The reason why a request is refused, in one sentence for the person at the editor.
class Refusal : public std::runtime_error {
 public:
  Refusal(RpcError code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] RpcError code() const noexcept { return code_; }

 private:
  RpcError code_;
};

[[nodiscard]] Json rpc_result(const Json& id, Json result);
[[nodiscard]] Json rpc_error(const Json& id, RpcError code, std::string_view message);
[[nodiscard]] Json rpc_notification(std::string_view method, Json params);

/// Returns JSON on one line. Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string dumped(const Json& json);

/// Returns the value at a path (`/a/b`) in `json`, or nullptr if any step of the path is missing.
[[nodiscard]] const Json* find_in(const Json& json, const Json::json_pointer& path);
/// Returns whether the value at `path` in a client's capabilities is true.
[[nodiscard]] bool is_true(const Json& json, const Json::json_pointer& path);

}  // namespace galilean::bhdl::lsp
