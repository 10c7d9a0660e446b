// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/guard.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <cctype>

namespace galilean::monitor {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& letter : result)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return result;
}

/// "[::1]:8080" -> "::1", "localhost:8080" -> "localhost".
std::string without_port(std::string_view host) {
  if (host.starts_with('[')) return lower(host.substr(1, host.find(']') - 1));
  return lower(host.substr(0, host.find(':')));
}

/// The origin that a browser's engine sends for a page that was opened as a file.
constexpr std::string_view kDesktopProgram = "file://";

}  // namespace

bool Guard::is_own_host(std::string_view host) const {
  const auto name = without_port(host);
  if (name == "localhost" || name == lower(listen_address_)) return true;
  boost::system::error_code not_an_address;
  const auto address = boost::asio::ip::make_address(name, not_an_address);
  if (not_an_address) return is_named_(name);  // anybody's DNS may point another name here
  const auto listens = boost::asio::ip::make_address(listen_address_, not_an_address);
  return address.is_loopback() || (!not_an_address && listens.is_unspecified());
}

bool Guard::is_allowed_origin(const std::string& origin) const {
  return std::ranges::find(allowed_origins_, lower(origin), lower) != allowed_origins_.end();
}

bool Guard::is_of_stranger(const HttpRequest& request) const {
  if (request.origin.empty() || is_allowed_origin(request.origin)) return false;
  return lower(request.origin) != kDesktopProgram &&
         lower(request.origin) != scheme_ + "://" + lower(request.host);
}

Result<void> Guard::admit(const HttpRequest& request) const {
  if (!is_own_host(request.host))
    return Error{"This monitor does not answer for the host '" + request.host +
                 "'; use localhost or the address that it listens on."};
  if (!is_of_stranger(request) || request.path.starts_with(kSharedPath)) return {};
  return Error{"Pages from '" + request.origin +
               "' may not use this monitor; start it with --allow-origin " + request.origin +
               " if they should."};
}

}  // namespace galilean::monitor
