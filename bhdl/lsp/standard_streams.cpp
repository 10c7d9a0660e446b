// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/standard_streams.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <iostream>

#include "bhdl/lsp/protocol/framing.h"

namespace galilean::bhdl::lsp {
namespace {

class Connection {
 public:
  Connection(Server& server, int input, int output)
      : server_(server), input_(input), output_(output) {}

  int run() {
    while (!server_.exit_status() && !broken_) {
      if (server_.has_work() && !input_waits())
        send(server_.work());
      else
        read_on();
    }
    return server_.exit_status().value_or(1);
  }

 private:
  [[nodiscard]] bool input_waits() const {
    pollfd poll_input{input_, POLLIN, 0};
    return poll(&poll_input, 1, 0) > 0;
  }

  void read_on() {
    std::array<char, 64 << 10> bytes;
    const ssize_t count = ::read(input_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) return;
    broken_ = count <= 0;
    if (broken_) return;
    framing_.feed({bytes.data(), static_cast<std::size_t>(count)});
    answer_all();
  }

  void answer_all() {
    while (!server_.exit_status() && !broken_) {
      const auto message = framing_.next();
      if (!message) return give_up(message.error().message);
      if (!message.value()) return;
      send(server_.receive(*message.value()));
    }
  }

  void give_up(const std::string& why) {
    send({dumped(rpc_error(nullptr, RpcError::kParse, why))});
    std::cerr << "galilean-bhdl: " << why << '\n';
    broken_ = true;
  }

  void send(const std::vector<std::string>& messages) {
    for (const auto& message : messages) write_all(framed(message));
  }

  void write_all(std::string_view bytes) {
    while (!bytes.empty() && !broken_) {
      const ssize_t count = ::write(output_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      broken_ = count <= 0;
      if (!broken_) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  Server& server_;
  int input_;
  int output_;
  Framing framing_;
  bool broken_ = false;
};

}  // namespace

int serve(Server& server, int input, int output) {
  return Connection(server, input, output).run();
}

}  // namespace galilean::bhdl::lsp
