// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/page_policy.h"

#include "bhdl/source/sha256.h"

namespace galilean::monitor {
namespace {

constexpr std::string_view kOpens = "<script>";
constexpr std::string_view kCloses = "</script>";
constexpr std::string_view kBase64 =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Returns a SHA-256, given as 64 hexadecimal digits, as base64 (RFC 4648).
std::string base64_of(std::string hex) {
  hex += "00";  // three digits make two of base64; the last of these stands for a byte that is none
  std::string text;
  for (std::size_t at = 0; at < hex.size(); at += 3) {
    const auto bits = std::stoul(hex.substr(at, 3), nullptr, 16);
    text += kBase64[bits >> 6];
    text += kBase64[bits & 63];
  }
  text.back() = '=';
  return text;
}

/// Returns a source of CSP for each script inside `html`, each after a space.
std::string script_hashes(std::string_view html) {
  std::string hashes;
  while (true) {
    const auto opens = html.find(kOpens);
    if (opens == std::string_view::npos) return hashes;
    html.remove_prefix(opens + kOpens.size());
    const auto closes = html.find(kCloses);
    if (closes == std::string_view::npos) return hashes;
    hashes += " 'sha256-" + base64_of(bhdl::sha256(html.substr(0, closes))) + "'";
    html.remove_prefix(closes);
  }
}

}  // namespace

std::string page_policy(std::string_view html) {
  return "default-src 'self'; script-src 'self'" + script_hashes(html) +
         "; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
         "worker-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; "
         "frame-ancestors 'none'";
}

std::string connect_policy(std::string_view host) {
  constexpr std::string_view kInNames =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.:-";
  std::string policy = "; connect-src 'self'";
  // The host comes from the request: nothing in it may begin another source or directive.
  if (host.empty() || host.find_first_not_of(kInNames) != host.npos) return policy;
  return policy.append(" ws://").append(host).append(" wss://").append(host);
}

}  // namespace galilean::monitor
