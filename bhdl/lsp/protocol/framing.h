// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/result.h"

namespace galilean::bhdl::lsp {

/// Cuts a stream of bytes into messages: `Content-Length: N`, other headers, an empty line, N
/// bytes.
class Framing {
 public:
  static constexpr std::size_t kMostHeaderBytes = 8 << 10;
  static constexpr std::size_t kMostMessageBytes = 32 << 20;

  void feed(std::string_view bytes) { waiting_.append(bytes); }
  /// Returns the next whole message, or nothing while it is incomplete. After an error the stream
  /// cannot be read on, because it is not known where the next message begins.
  [[nodiscard]] Result<std::optional<std::string>> next();

 private:
  [[nodiscard]] Result<std::optional<std::size_t>> read_header();

  std::string waiting_;
  std::optional<std::size_t> body_bytes_;
};

[[nodiscard]] std::string framed(std::string_view message);

}  // namespace galilean::bhdl::lsp
