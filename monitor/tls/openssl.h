// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <openssl/x509.h>
#include <openssl/x509v3.h>

#include <memory>
#include <string>

#include "core/openssl.h"

namespace galilean::monitor::openssl {

using galilean::openssl::Bio;
using galilean::openssl::Free;
using galilean::openssl::Key;
using Certificate = std::unique_ptr<X509, Free<X509_free>>;
using Extension = std::unique_ptr<X509_EXTENSION, Free<X509_EXTENSION_free>>;

/// Returns why OpenSSL's last call on this thread failed, and forgets it.
[[nodiscard]] std::string last_problem();

// What makes something returns it empty if OpenSSL fails, and false in place of true. Its reason is
// in OpenSSL's queue then, as last_problem() tells it.

/// Makes a private key on the curve P-256.
[[nodiscard]] Key make_key();
/// Adds an extension, of a kind of OpenSSL's (NID_...), by OpenSSL's text for it. `issuer` is the
/// certificate itself where that signs itself.
[[nodiscard]] bool add_extension(X509& certificate, X509& issuer, int kind,
                                 const std::string& value);
/// Adds a field, such as "CN", to a name.
[[nodiscard]] bool add_field(X509_NAME* name, const char* field, const std::string& text);
/// Returns all that was written into memory.
[[nodiscard]] std::string text_in(BIO& memory);
[[nodiscard]] std::string pem_of(X509& certificate);
[[nodiscard]] std::string pem_of(EVP_PKEY& key);

}  // namespace galilean::monitor::openssl
