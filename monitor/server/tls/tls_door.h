// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <functional>
#include <memory>
#include <string>

#include "core/result.h"
#include "monitor/tls/certificate.h"

namespace galilean::monitor {

/// The TLS of a server. Each connection gets a relay, which encrypts and decrypts between the
/// client's socket and one of a pair inside this process, so that sessions read and write plain
/// bytes and are compiled once. For use on the io_context's one thread.
class TlsDoor {
 public:
  /// Takes the session's end of a connection, and the client's address.
  using Admit =
      std::function<void(boost::asio::ip::tcp::socket socket, const std::string& address)>;

  /// How many clients may be in their handshake at once. Others are turned away.
  static constexpr long kMostHandshakes = 256;

  /// Errors: a file cannot be read, or key and certificate do not belong together.
  [[nodiscard]] static Result<std::shared_ptr<TlsDoor>> open(const CertificateFiles& files);
  ~TlsDoor();
  TlsDoor(const TlsDoor&) = delete;
  TlsDoor& operator=(const TlsDoor&) = delete;

  /// Returns whether the certificate is for a machine of this name.
  [[nodiscard]] bool is_named(const std::string& name) const;
  /// Returns why clients will not accept the certificate now, such as that it is over; empty if its
  /// time is no reason.
  [[nodiscard]] std::string objection() const;

  /// Shakes hands with a client, and calls `admit` if that succeeds. A client that speaks plain
  /// HTTP is told so in one sentence.
  void enter(boost::asio::ip::tcp::socket socket, Admit admit);

 private:
  struct Parts;
  explicit TlsDoor(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace galilean::monitor
