// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace galilean::monitor {

/// Returns the last `bytes` bytes of `value`, the highest first or last.
inline std::string bytes_of(std::uint64_t value, int bytes, bool highest_first) {
  std::string text;
  for (int i = 0; i < bytes; ++i)
    text += static_cast<char>(value >> (8 * (highest_first ? bytes - 1 - i : i)));
  return text;
}

/// Returns a message as a client's WebSocket frame (RFC 6455, 5.2), masked with zeros.
inline std::string client_frame(bool is_text, const std::string& message) {
  const auto size = message.size();
  const int length_bytes = size < 126 ? 0 : size < 65536 ? 2 : 8;
  std::string frame{static_cast<char>(is_text ? 0x81 : 0x82)};
  frame += static_cast<char>(0x80 | (length_bytes == 0 ? size : length_bytes == 2 ? 126 : 127));
  return frame + bytes_of(size, length_bytes, true) + std::string(4, '\0') + message;
}

/// Returns the protocol's binary message for a service call.
inline std::string service_call(std::uint32_t service_id, std::uint32_t call_id,
                                const std::string& body) {
  std::string call{2};
  for (const std::uint32_t number : {service_id, call_id, std::uint32_t{4}})
    call += bytes_of(number, 4, false);
  return call + "json" + body;
}

/// A client as a browser is one. It writes and reads the protocol byte by byte.
class FoxgloveSocket {
 public:
  explicit FoxgloveSocket(const std::string& host, std::uint16_t port,
                          const std::string& origin = {}, const std::string& target = "/ws")
      : stream_(io_) {
    boost::beast::get_lowest_layer(stream_).connect(
        {boost::asio::ip::address_v4::loopback(), port});
    stream_.set_option(boost::beast::websocket::stream_base::decorator([=](auto& message) {
      message.set(boost::beast::http::field::sec_websocket_protocol,
                  "other, foxglove.websocket.v1");
      if (!origin.empty()) message.set(boost::beast::http::field::origin, origin);
    }));
    stream_.handshake(response, host, target);
  }
  void send(const nlohmann::json& message) {
    stream_.text(true);
    stream_.write(boost::asio::buffer(message.dump()));
  }
  void subscribe(std::uint32_t channel_id) {
    send({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", channel_id}}}}});
  }
  void send_binary(const std::string& bytes) {
    stream_.binary(true);
    stream_.write(boost::asio::buffer(bytes));
  }
  /// Sends frames that client_frame() made, with one write to the connection.
  void send_at_once(const std::string& frames) {
    boost::asio::write(boost::beast::get_lowest_layer(stream_).socket(),
                       boost::asio::buffer(frames));
  }
  /// Returns the next message that is not the server's clock.
  std::string read() {
    for (;;) {
      boost::beast::flat_buffer buffer;
      stream_.read(buffer);
      auto text = boost::beast::buffers_to_string(buffer.data());
      if (stream_.got_text() || text[0] != 2) return text;
    }
  }
  /// Reads until the server closes the connection. Returns the server's reason.
  std::string read_to_the_end() {
    for (boost::system::error_code error;;) {
      boost::beast::flat_buffer buffer;
      stream_.read(buffer, error);
      if (error) return stream_.reason().reason.c_str();
    }
  }
  nlohmann::json read_op(const std::string& op) {
    for (;;)
      if (auto message = nlohmann::json::parse(read(), nullptr, false);
          message.is_object() && message["op"] == op)
        return message;
  }
  nlohmann::json services() { return read_op("advertiseServices")["services"]; }
  std::uint32_t channel(const std::string& topic) {
    for (;;) {
      const auto channels = read_op("advertise")["channels"];
      for (const auto& channel : channels)
        if (channel["topic"] == topic) return channel["id"];
    }
  }
  boost::beast::websocket::response_type response;

 private:
  boost::asio::io_context io_;
  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
};

}  // namespace galilean::monitor
