// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/commands/exchange.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/ssl/error.hpp>
#include <boost/asio/ssl/host_name_verification.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/write.hpp>
#include <type_traits>
#include <utility>

#include "monitor/tls/certificate.h"

namespace galilean::monitor {
namespace {

namespace asio = boost::asio;
namespace ssl = asio::ssl;
using asio::ip::tcp;
using boost::system::error_code;
using TlsStream = ssl::stream<tcp::socket>;

constexpr std::uint64_t kMostExchangedBytes = 64 << 20;

/// One request and its answer, on a connection of its own, which the monitor closes. `Stream` is a
/// tcp::socket or a TlsStream.
template <class Stream>
class Exchange {
 public:
  /// `parts` make the stream.
  template <class... Parts>
  explicit Exchange(const std::string& request, Parts&&... parts)
      : stream_(std::forward<Parts>(parts)...), request_(request) {}

  void start(const tcp::resolver::results_type& endpoints) {
    asio::async_connect(stream_.lowest_layer(), endpoints, [this](error_code error, const auto&) {
      if (!failed(error)) shake_hands();
    });
  }
  [[nodiscard]] Stream& stream() { return stream_; }
  [[nodiscard]] Exchanged take() { return std::move(result_); }

 private:
  bool failed(error_code error) {
    if (error) result_.error = error;
    return bool(error);
  }
  void shake_hands() {
    if constexpr (std::is_same_v<Stream, TlsStream>)
      stream_.async_handshake(ssl::stream_base::client, [this](error_code error) {
        result_.is_distrusted = error.category() == asio::error::get_ssl_category() &&
                                SSL_get_verify_result(stream_.native_handle()) != X509_V_OK;
        if (!failed(error)) write();
      });
    else
      write();
  }
  void write() {
    result_.was_sent = true;
    asio::async_write(stream_, asio::buffer(request_), [this](error_code error, std::size_t) {
      if (!failed(error)) read();
    });
  }
  void read() {
    asio::async_read(stream_, asio::dynamic_buffer(result_.answer, kMostExchangedBytes),
                     [this](error_code error, std::size_t) {
                       result_.error = error == asio::error::eof ? error_code() : error;
                     });
  }

  Stream stream_;
  std::string request_;
  Exchanged result_{.answer = {}, .error = asio::error::timed_out};
};

template <class Stream>
Exchanged run_exchange(asio::io_context& io, Exchange<Stream>& request,
                       const tcp::resolver::results_type& endpoints, std::chrono::seconds longest) {
  request.start(endpoints);
  io.run_for(longest);
  return request.take();
}

/// Accepts the one certificate that has this fingerprint, whoever vouches for it.
bool is_pinned(const std::string& fingerprint, ssl::verify_context& verified) {
  X509_STORE_CTX* chain = verified.native_handle();
  if (X509_STORE_CTX_get_error_depth(chain) > 0) return true;
  const X509* certificate = X509_STORE_CTX_get_current_cert(chain);
  return certificate != nullptr && fingerprint_of(*certificate) == fingerprint;
}

Result<ssl::context> client_context(const ServerTrust& trust, const std::string& host) {
  ssl::context context(ssl::context::tls_client);
  context.set_options(ssl::context::no_tlsv1 | ssl::context::no_tlsv1_1);
  context.set_verify_mode(ssl::verify_peer);
  if (!trust.fingerprint.empty()) {
    context.set_verify_callback([wanted = trust.fingerprint](bool, ssl::verify_context& verified) {
      return is_pinned(wanted, verified);
    });
    return context;
  }
  error_code error;
  if (trust.ca_file.empty())
    context.set_default_verify_paths(error);
  else
    context.load_verify_file(trust.ca_file, error);
  if (error)
    return Error{(trust.ca_file.empty() ? "this machine's certificates" : trust.ca_file) +
                 " cannot be read: " + error.message()};
  context.set_verify_callback(ssl::host_name_verification(host));
  return context;
}

/// Names the host to a server that has several certificates.
void name_host(TlsStream& stream, std::string host) {
  error_code no_address;
  (void)asio::ip::make_address(host, no_address);
  if (no_address)  // else TLS has no word for it
    SSL_ctrl(stream.native_handle(), SSL_CTRL_SET_TLSEXT_HOSTNAME, TLSEXT_NAMETYPE_host_name,
             host.data());
}

}  // namespace

std::string without_brackets(const std::string& host) {
  return host.starts_with('[') ? host.substr(1, host.size() - 2) : host;
}

Result<Exchanged> exchange(const MonitorAddress& address, const ServerTrust& trust,
                           const std::string& request, std::chrono::seconds longest) {
  asio::io_context io;
  const auto host = without_brackets(address.host);
  error_code unknown;
  tcp::resolver resolver(io);
  const auto endpoints = resolver.resolve(host, address.port, unknown);
  if (unknown) return Exchanged{.answer = {}, .error = unknown};
  if (!address.is_encrypted) {
    Exchange<tcp::socket> plain(request, io);
    return run_exchange(io, plain, endpoints, longest);
  }
  auto context = client_context(trust, host);
  if (!context) return context.error();
  auto tls = std::move(context).value();
  Exchange<TlsStream> encrypted(request, io, tls);
  name_host(encrypted.stream(), host);
  return run_exchange(io, encrypted, endpoints, longest);
}

}  // namespace galilean::monitor
