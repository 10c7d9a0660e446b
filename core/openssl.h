// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <openssl/bio.h>
#include <openssl/evp.h>

#include <memory>

namespace galilean::openssl {

// All is inline, so that only who includes it is linked with OpenSSL.

/// Frees what OpenSSL allocates.
template <auto free_it>
struct Free {
  template <class T>
  void operator()(T* object) const noexcept {
    free_it(object);
  }
};

using Key = std::unique_ptr<EVP_PKEY, Free<EVP_PKEY_free>>;
using Bio = std::unique_ptr<BIO, Free<BIO_free_all>>;

}  // namespace galilean::openssl
