// SPDX-License-Identifier: BSD-3-Clause
#include "core/signing/key_files.h"

#include <algorithm>

#include "core/signing/trusted_keys.h"

namespace galilean {

std::string trust_line(const VerifyingKey& key, const std::string& name) {
  std::string shown = name;
  std::ranges::replace_if(
      shown, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return std::string(kKeyKind) + " " + key.text() + " " + shown + "\n";
}

std::optional<VerifyingKey> first_key_in(const std::filesystem::path& file) {
  const auto keys = TrustedKeys::load(file);
  if (!keys) return std::nullopt;
  return keys.value().all().front().key;
}

}  // namespace galilean
