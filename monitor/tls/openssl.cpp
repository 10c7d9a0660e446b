// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/tls/openssl.h"

#include <openssl/err.h>
#include <openssl/pem.h>

#include <array>

namespace galilean::monitor::openssl {

std::string last_problem() {
  const auto code = ERR_get_error();
  ERR_clear_error();
  if (code == 0) return "for an unknown reason";
  std::array<char, 256> text{};
  ERR_error_string_n(code, text.data(), text.size());
  return text.data();
}

Key make_key() {
  return Key(EVP_PKEY_Q_keygen(nullptr, nullptr, "EC", "P-256"));
}

bool add_extension(X509& certificate, X509& issuer, int kind, const std::string& value) {
  X509V3_CTX context;
  X509V3_set_ctx_nodb(&context);
  X509V3_set_ctx(&context, &issuer, &certificate, nullptr, nullptr, 0);
  const Extension extension(X509V3_EXT_conf_nid(nullptr, &context, kind, value.c_str()));
  return extension && X509_add_ext(&certificate, extension.get(), -1) == 1;
}

bool add_field(X509_NAME* name, const char* field, const std::string& text) {
  return X509_NAME_add_entry_by_txt(name, field, MBSTRING_UTF8,
                                    reinterpret_cast<const unsigned char*>(text.data()),
                                    static_cast<int>(text.size()), -1, 0) == 1;
}

std::string text_in(BIO& memory) {
  char* data = nullptr;
  const long size = BIO_get_mem_data(&memory, &data);
  return size > 0 ? std::string(data, static_cast<std::size_t>(size)) : std::string();
}

std::string pem_of(X509& certificate) {
  const Bio memory(BIO_new(BIO_s_mem()));
  const bool is_written = memory && PEM_write_bio_X509(memory.get(), &certificate) == 1;
  return is_written ? text_in(*memory) : std::string();
}

std::string pem_of(EVP_PKEY& key) {
  const Bio memory(BIO_new(BIO_s_mem()));
  const bool is_written = memory && PEM_write_bio_PrivateKey(memory.get(), &key, nullptr, nullptr,
                                                             0, nullptr, nullptr) == 1;
  return is_written ? text_in(*memory) : std::string();
}

}  // namespace galilean::monitor::openssl
