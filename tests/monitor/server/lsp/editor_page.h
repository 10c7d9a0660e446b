// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace galilean::monitor {

/// The page's editor, which speaks with the language server over a WebSocket.
class EditorPage {
 public:
  explicit EditorPage(std::uint16_t port, const std::string& target = "/lsp",
                      const std::string& origin = {})
      : stream_(io_) {
    boost::beast::get_lowest_layer(stream_).connect(
        {boost::asio::ip::address_v4::loopback(), port});
    stream_.set_option(boost::beast::websocket::stream_base::decorator([=](auto& message) {
      if (!origin.empty()) message.set(boost::beast::http::field::origin, origin);
    }));
    stream_.handshake("127.0.0.1:" + std::to_string(port), target);
  }
  void send(const nlohmann::json& message) { stream_.write(boost::asio::buffer(message.dump())); }
  nlohmann::json next() {
    boost::beast::flat_buffer buffer;
    stream_.read(buffer);
    return nlohmann::json::parse(boost::beast::buffers_to_string(buffer.data()));
  }
  nlohmann::json ask(const std::string& method, const nlohmann::json& params) {
    send({{"jsonrpc", "2.0"}, {"id", ++last_id_}, {"method", method}, {"params", params}});
    for (;;)
      if (auto answer = next(); answer.value("id", 0) == last_id_) return answer;
  }
  void start(const std::string& text) {
    (void)ask("initialize", {{"capabilities", nlohmann::json::object()}});
    send({{"jsonrpc", "2.0"},
          {"method", "textDocument/didOpen"},
          {"params",
           {{"textDocument", {{"uri", "file:///mine.bhdl"}, {"version", 1}, {"text", text}}}}}});
  }
  /// What may stand at the text's beginning of a component.
  std::string proposed() {
    return ask("textDocument/completion",
               {{"textDocument", {{"uri", "file:///mine.bhdl"}}},
                {"position", {{"line", 1}, {"character", 0}}}})["result"]["items"]
        .dump();
  }

 private:
  boost::asio::io_context io_;
  boost::beast::websocket::stream<boost::asio::ip::tcp::socket> stream_;
  int last_id_ = 0;
};

}  // namespace galilean::monitor
