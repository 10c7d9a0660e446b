// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "monitor/server/http/http_messages.h"

namespace galilean::monitor {

/// Lets through only those who mean this server, on HTTP and WebSocket alike.
///
/// A page from elsewhere can make its reader's browser send requests here, and by DNS rebinding
/// even read the answers; the browser then names the page's own host in Host, and the page in
/// Origin. Host must be a name of the loopback interface or the address that the server listens on
/// (any address, where it listens on all); Origin, where there is one, must be this same host or
/// one that the operator allowed. A page that was opened as a file may ask as well: the desktop
/// programs of Foxglove and Lichtblick are such, and no site can name itself so.
class Guard {
 public:
  /// `allowed_origins` as a browser sends them: "https://studio.example.org".
  Guard(std::string listen_address, std::vector<std::string> allowed_origins)
      : listen_address_(std::move(listen_address)), allowed_origins_(std::move(allowed_origins)) {}

  /// Why the request is refused; empty if it may pass.
  [[nodiscard]] std::string objection(const HttpRequest& request) const;
  /// Another page than our own, which the operator allowed.
  [[nodiscard]] bool is_allowed_stranger(const std::string& origin) const;

 private:
  [[nodiscard]] bool means_us(std::string_view host) const;

  std::string listen_address_;
  std::vector<std::string> allowed_origins_;
};

}  // namespace galilean::monitor
