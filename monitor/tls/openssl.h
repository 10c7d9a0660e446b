// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/x509.h>
#include <openssl/x509v3.h>

#include <memory>
#include <string>

namespace galilean::monitor::openssl {

/// Frees what OpenSSL allocates.
template <auto free_it>
struct Freeing {
  template <class T>
  void operator()(T* object) const noexcept {
    free_it(object);
  }
};
using Key = std::unique_ptr<EVP_PKEY, Freeing<EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, Freeing<X509_free>>;
using Extension = std::unique_ptr<X509_EXTENSION, Freeing<X509_EXTENSION_free>>;
using Memory = std::unique_ptr<BIO, Freeing<BIO_free_all>>;

/// Returns why OpenSSL's last call on this thread failed, and forgets it.
[[nodiscard]] std::string last_problem();

}  // namespace galilean::monitor::openssl
