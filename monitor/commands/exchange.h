// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/system/error_code.hpp>
#include <chrono>
#include <string>

#include "core/result.h"

namespace galilean::monitor {

/// Where a monitor is.
struct MonitorAddress {
  std::string host;  ///< with brackets if it is an IPv6 address
  std::string port;
  bool is_encrypted = false;  ///< it speaks TLS
};

/// How a monitor's certificate is judged. With neither, the certificates count that this machine
/// trusts.
struct ServerTrust {
  std::string ca_file;      ///< PEM file of the certificates to trust instead; empty: none
  std::string fingerprint;  ///< of the one certificate to trust, as fingerprint_of() writes it

  [[nodiscard]] bool is_empty() const { return ca_file.empty() && fingerprint.empty(); }
};

/// What came of one request.
struct Exchanged {
  std::string answer;               ///< all bytes of it
  boost::system::error_code error;  ///< timed_out if there was no end
  bool was_sent = false;            ///< the monitor may have got the request
  bool is_distrusted = false;       ///< its certificate is not what it should be
};

/// Sends one request on a connection of its own, and waits until the monitor has closed that, for
/// `longest` at most.
/// Errors: the certificates to trust cannot be read.
[[nodiscard]] Result<Exchanged> exchange(const MonitorAddress& address, const ServerTrust& trust,
                                         const std::string& request, std::chrono::seconds longest);

/// Returns "::1" for "[::1]".
[[nodiscard]] std::string without_brackets(const std::string& host);

}  // namespace galilean::monitor
