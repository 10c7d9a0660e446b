// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "monitor/server/http/http_messages.h"

namespace galilean::monitor {

/// Refuses requests that a page of another site makes a browser send, on HTTP and WebSocket alike.
///
/// A page of another site can make its reader's browser send requests here. By DNS rebinding it can
/// even read the answers. The browser then names the page's host in the Host field or the page's
/// site in the Origin field. Host must therefore be "localhost", a loopback address or the address
/// that the server listens on; it may be any address if the server listens on all. With TLS it may
/// also be a name of the certificate, which no browser accepts for another site. Origin, if it is
/// sent, must be this host with the scheme that is served here, or a site that the operator
/// allowed. The origin "file://" passes, too: the desktop programs of Foxglove and Lichtblick send
/// it, and no site can send it.
///
/// Files below kSharedPath are there for pages of any site, so that viewers in a browser open a
/// recording by its address. Such a page needs a token, also where reading is free for others.
class Guard {
 public:
  static constexpr std::string_view kSharedPath = "/recordings/";

  /// `allowed_origins` are written as a browser sends them: "https://studio.example.org". `scheme`
  /// is what this server is asked by, "http" or "https".
  Guard(std::string listen_address, std::vector<std::string> allowed_origins,
        std::string scheme = "http")
      : listen_address_(std::move(listen_address)),
        allowed_origins_(std::move(allowed_origins)),
        scheme_(std::move(scheme)) {}

  /// Lets requests through for hosts of which `is_named` returns true, too.
  void answer_also_for(std::function<bool(const std::string& name)> is_named) {
    is_named_ = std::move(is_named);
  }
  /// Errors: the request is refused; the error is a sentence for its author.
  [[nodiscard]] Result<void> admit(const HttpRequest& request) const;
  /// Returns whether a page of another site sent the request that was not allowed to.
  [[nodiscard]] bool is_of_stranger(const HttpRequest& request) const;
  /// Returns whether the operator allowed this origin.
  [[nodiscard]] bool is_allowed_origin(const std::string& origin) const;

 private:
  [[nodiscard]] bool is_own_host(std::string_view host) const;

  std::string listen_address_;
  std::vector<std::string> allowed_origins_;
  std::string scheme_;
  std::function<bool(const std::string& name)> is_named_ = [](const std::string&) { return false; };
};

}  // namespace galilean::monitor
