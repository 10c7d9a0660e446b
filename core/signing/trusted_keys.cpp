// SPDX-License-Identifier: BSD-3-Clause
#include "core/signing/trusted_keys.h"

#include <sys/stat.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "core/regular_file.h"

namespace galilean {
namespace {

constexpr std::uintmax_t kMostTrustBytes = 1024 * 1024;
constexpr const char* kSpaces = " \t\r";

/// Returns the text without spaces at its ends.
std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(kSpaces);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kSpaces) - first + 1);
}

/// Reads "ed25519 BASE64 NAME". Errors: the line has another form.
Result<TrustedKeys::Trusted> key_in(const std::string& line) {
  std::istringstream words(line);
  std::string kind, text, name;
  words >> kind >> text;
  std::getline(words, name);
  if (kind != kKeyKind)
    return Error{"a line begins with 'ed25519', as in operator.key.pub, or with '#'"};
  auto key = VerifyingKey::from_text(text);
  if (!key) return key.error();
  return TrustedKeys::Trusted{key.value().id(), trimmed(name), key.value()};
}

}  // namespace

Result<TrustedKeys> TrustedKeys::load(const std::filesystem::path& file) {
  const auto text = read_regular_file(file.string(), kMostTrustBytes);
  if (!text) return Error{file.string() + " cannot be read: " + text.error().message};
  struct stat status {};
  if (stat(file.c_str(), &status) == 0 && (status.st_mode & S_IWOTH) != 0)
    return Error{file.string() +
                 " may be written by everybody, who could add a key: look at it, and run 'chmod "
                 "o-w " +
                 file.string() + "'"};
  return read(text.value(), file.string());
}

Result<TrustedKeys> TrustedKeys::read(std::string_view text, const std::string& file) {
  if (text.find("PRIVATE KEY-----") != text.npos)
    return Error{file +
                 " is a private key, which its owner alone should have: name a file of what "
                 "'galilean keys' prints, such as operator.key.pub"};
  TrustedKeys keys;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line = trimmed(line);
    if (line.empty() || line.starts_with('#')) continue;
    auto key = key_in(line);
    if (!key) return Error{file + ":" + std::to_string(number) + ": " + key.error().message};
    if (!keys.find(key.value().id)) keys.keys_.push_back(std::move(key).value());
  }
  if (keys.keys_.empty())
    return Error{file + " names no key: copy the line of the monitor's operator.key.pub into it"};
  return keys;
}

const TrustedKeys::Trusted* TrustedKeys::find(std::string_view id) const noexcept {
  const auto found = std::ranges::find(keys_, id, &Trusted::id);
  return found == keys_.end() ? nullptr : &*found;
}

}  // namespace galilean
