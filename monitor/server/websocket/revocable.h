// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean::monitor {

/// A WebSocket's session that ends when its client's token does. For use on the io_context's
/// thread.
class Revocable {
 public:
  virtual ~Revocable() = default;
  /// Sends and obeys nothing more, and closes with this reason. A client that does not answer the
  /// close frame stays connected for a while.
  virtual void revoke(const std::string& reason) = 0;
  /// Ends the connection at once.
  virtual void cut() = 0;
};

}  // namespace galilean::monitor
