// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/operator_key.h"

#include <unistd.h>

#include <array>
#include <utility>

#include "core/account.h"
#include "monitor/access/tokens.h"

namespace galilean::monitor {
namespace {

/// Returns whose key it is, such as "anna@laptop".
std::string key_owner() {
  std::array<char, 256> host{};
  const bool is_known = gethostname(host.data(), host.size() - 1) == 0;
  return user_name() + "@" + (is_known ? host.data() : "unknown");
}

}  // namespace

std::filesystem::path operator_key_file(const std::filesystem::path& data_folder) {
  return data_folder / "operator.key";
}

Result<SigningKey> open_operator_key(const std::filesystem::path& data_folder) {
  return load_or_make_key(operator_key_file(data_folder), key_owner());
}

Result<std::shared_ptr<OrderSigner>> find_signer(const std::string& key_file) {
  std::filesystem::path file = key_file;
  if (key_file.empty()) {
    file = operator_key_file(default_data_folder());
    std::error_code unknown;
    if (!std::filesystem::exists(file, unknown)) return std::shared_ptr<OrderSigner>();
  }
  auto key = SigningKey::load(file);
  if (!key) return key.error();
  return signer_of(std::move(key).value(), file);
}

std::shared_ptr<OrderSigner> signer_of(SigningKey key, const std::filesystem::path& key_file) {
  return std::make_shared<OrderSigner>(std::move(key), wire::wall_clock_ns, number_file(key_file));
}

CommandLineOption add_key_option(CommandLine& line, std::string& key_file,
                                 const std::string& note) {
  const std::string help =
      "private key that signs the order [operator.key, where the monitor keeps it]";
  return line.option("--key", key_file, note.empty() ? help : help + " (" + note + ")")
      .names_file();
}

}  // namespace galilean::monitor
