// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/tls/tls_door.h"

#include <openssl/x509v3.h>

#include <boost/asio/ssl/context.hpp>
#include <utility>

#include "monitor/server/tls/tls_relay.h"

namespace galilean::monitor {
namespace {

namespace ssl = boost::asio::ssl;

/// Returns a context that knows neither TLS 1.1 nor anything older.
ssl::context server_context() {
  ssl::context context(ssl::context::tls_server);
  context.set_options(ssl::context::default_workarounds | ssl::context::no_sslv2 |
                      ssl::context::no_sslv3 | ssl::context::no_tlsv1 | ssl::context::no_tlsv1_1);
  SSL_CTX_set_options(context.native_handle(), SSL_OP_NO_RENEGOTIATION);
  // A key with a password is refused. OpenSSL would otherwise wait for somebody to type it.
  context.set_password_callback(
      [](std::size_t, ssl::context::password_purpose) { return std::string(); });
  return context;
}

}  // namespace

struct TlsDoor::Parts {
  ssl::context context = server_context();
  std::shared_ptr<int> places = std::make_shared<int>();  ///< a relay in its handshake shares it
};

TlsDoor::TlsDoor(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
TlsDoor::~TlsDoor() = default;

Result<std::shared_ptr<TlsDoor>> TlsDoor::open(const CertificateFiles& files) {
  auto parts = std::make_unique<Parts>();
  boost::system::error_code error;
  parts->context.use_certificate_chain_file(files.certificate.string(), error);
  if (error)
    return Error{files.certificate.string() + " has no certificate in PEM: " + error.message()};
  parts->context.use_private_key_file(files.key.string(), ssl::context::pem, error);
  const auto unusable = [&](const std::string& why) {
    return Error{files.key.string() + " has no private key in PEM, without a password, for " +
                 files.certificate.string() + ": " + why};
  };
  if (error) return unusable(error.message());
  // A key of another kind than the certificate's is not noticed before.
  if (SSL_CTX_check_private_key(parts->context.native_handle()) != 1)
    return unusable("they do not belong together");
  return std::shared_ptr<TlsDoor>(new TlsDoor(std::move(parts)));
}

bool TlsDoor::is_named(const std::string& name) const {
  X509* certificate = SSL_CTX_get0_certificate(parts_->context.native_handle());
  // An empty name would fit every certificate.
  return certificate != nullptr && !name.empty() &&
         X509_check_host(certificate, name.data(), name.size(), 0, nullptr) == 1;
}

std::string TlsDoor::objection() const {
  const X509* certificate = SSL_CTX_get0_certificate(parts_->context.native_handle());
  if (certificate == nullptr) return {};
  if (X509_cmp_current_time(X509_get0_notAfter(certificate)) < 0)
    return "the certificate is over, and clients refuse it: renew it";
  if (X509_cmp_current_time(X509_get0_notBefore(certificate)) > 0)
    return "the certificate's time has not begun, and clients refuse it: is this machine's clock "
           "right?";
  return {};
}

void TlsDoor::enter(boost::asio::ip::tcp::socket socket, Admit admit) {
  if (parts_->places.use_count() > kMostHandshakes) return;
  std::make_shared<TlsRelay>(std::move(socket), parts_->context, parts_->places, std::move(admit))
      ->start();
}

}  // namespace galilean::monitor
