// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/named_tokens.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <functional>
#include <utility>

#include "core/file_lock.h"
#include "core/json_text.h"
#include "core/private_file.h"
#include "core/regular_file.h"
#include "core/spelling.h"
#include "core/visible_text.h"
#include "monitor/access/digest.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kTokenBytes = 32;
constexpr std::uintmax_t kMostFileBytes = 4 << 20;
constexpr std::size_t kDigestDigits = 64;
constexpr std::size_t kLongestName = 64;

std::optional<Right> right_of_role(const std::string& role) {
  for (const Right right : {Right::kRead, Right::kOperate})
    if (role == role_of(right)) return right;
  return {};
}

bool is_digest(const std::string& text) {
  return text.size() == kDigestDigits &&
         text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

json json_of(const NamedToken& token) {
  json result{{"name", token.name},
              {"role", std::string(role_of(token.right))},
              {"sha256", token.sha256},
              {"made_s", token.made_s}};
  if (token.expires_s) result["expires_s"] = *token.expires_s;
  return result;
}

/// Returns nothing if the value is no whole number that fits. Its conversion would make some time
/// of a fraction, of true and of a number that is too large.
std::optional<std::int64_t> seconds_of(const json& value) {
  if (value.is_number_unsigned() && !std::in_range<std::int64_t>(value.get<std::uint64_t>()))
    return {};
  if (!value.is_number_integer()) return {};
  return value.get<std::int64_t>();
}

Result<NamedToken> token_of(const json& item) try {
  NamedToken token{.name = item.at("name").get<std::string>(),
                   .right = Right::kRead,
                   .sha256 = item.at("sha256").get<std::string>(),
                   .made_s = 0,
                   .expires_s = {}};
  const auto made_s = seconds_of(item.at("made_s"));
  if (item.contains("expires_s")) token.expires_s = seconds_of(item.at("expires_s"));
  if (!made_s || (item.contains("expires_s") && !token.expires_s))
    return Error{"a time of '" + visible(token.name) + "' is not a whole number of seconds"};
  token.made_s = *made_s;
  const auto right = right_of_role(item.at("role").get<std::string>());
  if (!right) return Error{"the role of '" + visible(token.name) + "' is not operator or viewer"};
  if (!is_digest(token.sha256))
    return Error{"the sha256 of '" + visible(token.name) + "' is not 64 hexadecimal digits"};
  token.right = *right;
  return token;
} catch (const json::exception& error) {
  return Error{error.what()};
}

Result<std::vector<NamedToken>> tokens_of(const json& document) {
  const auto list = document.is_object() ? document.find("tokens") : document.end();
  if (list == document.end() || !list->is_array()) return Error{"it has no list \"tokens\""};
  std::vector<NamedToken> tokens;
  for (const auto& item : *list) {
    auto token = token_of(item);
    if (!token) return token.error();
    tokens.push_back(std::move(token).value());
  }
  return tokens;
}

Result<void> write_named_tokens(const fs::path& file, const std::vector<NamedToken>& tokens) {
  json list = json::array();
  for (const auto& token : tokens) list.push_back(json_of(token));
  return replace_private_file(file, json_text({{"tokens", std::move(list)}}, 1) + "\n");
}

using Edit = std::function<Result<void>(std::vector<NamedToken>&)>;

Result<void> edit_named_tokens(const fs::path& data_folder, const Edit& edit) {
  if (auto made = make_private_folder(data_folder); !made) return made;
  const auto lock = FileLock::wait_for(data_folder / "tokens.lock");
  if (!lock) return lock.error();
  const auto file = named_tokens_file(data_folder);
  auto tokens = read_named_tokens(file);
  if (!tokens) return tokens.error();
  auto edited = std::move(tokens).value();
  if (auto done = edit(edited); !done) return done;
  return write_named_tokens(file, edited);
}

Result<void> check_name(const std::string& name) {
  constexpr const char* kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._@-";
  if (name.empty() || name.size() > kLongestName ||
      name.find_first_not_of(kAllowed) != std::string::npos)
    return Error{"'" + visible(name) +
                 "' is not a valid name: it has 1 to 64 letters, digits, or characters of ._@-"};
  if (name == "operator" || name == "viewer")
    return Error{"'" + name + "' is the token in " + name + ".token; choose another name"};
  return {};
}

}  // namespace

std::string_view role_of(Right right) noexcept {
  return right == Right::kOperate ? "operator" : "viewer";
}

std::int64_t wall_clock_s() {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::seconds>(since_1970).count();
}

fs::path named_tokens_file(const fs::path& data_folder) {
  return data_folder / "tokens.json";
}

Result<std::vector<NamedToken>> read_named_tokens(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0 && (errno == ENOENT || errno == ENOTDIR))
    return std::vector<NamedToken>();
  if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0)
    return Error{file.string() +
                 " may be written by others, who could give themselves rights; look at it with "
                 "'galilean tokens list' after 'chmod 600'"};
  const auto damaged = [&](const Error& why) {
    return Error{file.string() + " is damaged: " + why.message +
                 "; correct it, or remove it, which revokes all tokens in it"};
  };
  const auto text = read_regular_file(file.string(), kMostFileBytes);
  if (!text) return Error{file.string() + " cannot be read: " + text.error().message};
  const auto document = read_json(text.value());
  if (!document) return damaged(document.error());
  auto tokens = tokens_of(document.value());
  if (!tokens) return damaged(tokens.error());
  return tokens;
}

Result<std::string> add_named_token(const fs::path& data_folder, NamedToken wanted) {
  if (const auto right = check_name(wanted.name); !right) return right.error();
  auto token = random_token(kTokenBytes);
  if (!token) return token;
  wanted.sha256 = digest_of(token.value());
  const auto done = edit_named_tokens(data_folder, [&](std::vector<NamedToken>& tokens) {
    std::erase_if(tokens, [&](const NamedToken& each) {
      return each.name == wanted.name && each.is_expired(wanted.made_s);
    });
    if (std::ranges::find(tokens, wanted.name, &NamedToken::name) != tokens.end())
      return Result<void>(Error{"'" + wanted.name + "' has a token already; revoke it first with " +
                                "'galilean tokens revoke " + wanted.name + "'"});
    tokens.push_back(wanted);
    return Result<void>();
  });
  if (!done) return done.error();
  return token;
}

Result<void> revoke_named_token(const fs::path& data_folder, const std::string& name) {
  return edit_named_tokens(data_folder, [&](std::vector<NamedToken>& tokens) {
    const auto found = std::ranges::find(tokens, name, &NamedToken::name);
    if (found == tokens.end()) {
      const auto meant = meant_name(name, names_of(tokens));
      return Result<void>(Error{"there is no token '" + visible(name) + "'" +
                                (meant.empty() ? "; 'galilean tokens list' tells which there are"
                                               : "; did you mean '" + meant + "'?")});
    }
    tokens.erase(found);
    return Result<void>();
  });
}

}  // namespace galilean::monitor
