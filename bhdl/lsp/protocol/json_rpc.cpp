// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/protocol/json_rpc.h"

#include "core/json_text.h"

namespace galilean::bhdl::lsp {

Json rpc_result(const Json& id, Json result) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}};
}

Json rpc_error(const Json& id, RpcError code, std::string_view message) {
  return {{"jsonrpc", "2.0"},
          {"id", id},
          {"error", {{"code", static_cast<int>(code)}, {"message", message}}}};
}

Json rpc_notification(std::string_view method, Json params) {
  return {{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
}

std::string dumped(const Json& json) {
  return json_text(json);
}

const Json* find_in(const Json& json, const Json::json_pointer& path) {
  return json.is_object() && json.contains(path) ? &json.at(path) : nullptr;
}

bool is_true(const Json& json, const Json::json_pointer& path) {
  const Json* found = find_in(json, path);
  return found != nullptr && found->is_boolean() && found->get<bool>();
}

}  // namespace galilean::bhdl::lsp
