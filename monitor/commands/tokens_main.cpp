// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/command_line/command_line.h"
#include "core/command_line/seconds_of.h"
#include "core/json_text.h"
#include "core/time_text.h"
#include "core/visible_text.h"
#include "monitor/access/named_tokens.h"
#include "monitor/access/tokens.h"

namespace {

using namespace galilean::monitor;
using galilean::Result, galilean::Error, galilean::utc_text;

constexpr const char* kCommand = "galilean tokens";

int fail(const std::string& why) {
  std::cerr << kCommand << ": " << why << '\n';
  return galilean::kFailed;
}

int add(const std::filesystem::path& data_folder, NamedToken wanted, double expires_after_s) {
  wanted.made_s = wall_clock_s();
  if (expires_after_s > 0)
    wanted.expires_s = wanted.made_s + static_cast<std::int64_t>(expires_after_s);
  const auto token = add_named_token(data_folder, wanted);
  if (!token) return fail(token.error().message);
  std::cout << token.value() << std::endl;
  std::cerr << "This is " << wanted.name << "'s token, of the role " << role_of(wanted.right)
            << (wanted.expires_s ? ", until " + utc_text(*wanted.expires_s) : "")
            << ". It is printed only once and kept nowhere.\n"
            << "It goes behind the page's address: http://HOST:PORT/#token=TOKEN\n";
  return EXIT_SUCCESS;
}

int print_json(const std::vector<NamedToken>& tokens, std::int64_t now_s) {
  auto list = nlohmann::json::array();
  for (const auto& token : tokens) {
    nlohmann::json item{{"name", token.name},
                        {"role", std::string(role_of(token.right))},
                        {"made", utc_text(token.made_s)},
                        {"expired", token.is_expired(now_s)}};
    item["expires"] = nullptr;
    if (token.expires_s) item["expires"] = utc_text(*token.expires_s);
    list.push_back(std::move(item));
  }
  std::cout << galilean::json_text({{"tokens", std::move(list)}}, 1) << std::endl;
  return EXIT_SUCCESS;
}

int list(const std::filesystem::path& data_folder, bool as_json) {
  const auto file = named_tokens_file(data_folder);
  const auto tokens = read_named_tokens(file);
  if (!tokens) return fail(tokens.error().message);
  const auto now_s = wall_clock_s();
  if (as_json) return print_json(tokens.value(), now_s);
  for (const auto& token : tokens.value())
    std::cout << galilean::visible(token.name) << "  " << role_of(token.right) << "  made "
              << utc_text(token.made_s)
              << (token.expires_s ? (token.is_expired(now_s) ? "  expired " : "  expires ") +
                                        utc_text(*token.expires_s)
                                  : "")
              << '\n';
  if (tokens.value().empty())
    std::cerr << kCommand << ": there is no named token in " << file.string() << '\n';
  return EXIT_SUCCESS;
}

int revoke(const std::filesystem::path& data_folder, const std::string& name) {
  if (const auto done = revoke_named_token(data_folder, name); !done)
    return fail(done.error().message);
  std::cerr << name << "'s token is revoked. What it opened at a monitor that uses "
            << data_folder.string() << " closes within a second.\n";
  return EXIT_SUCCESS;
}

/// Reads how long a token is valid.
Result<void> read_expiry(const std::string& text, double& target_s) {
  constexpr double kLongest_s = 100.0 * 365 * 24 * 3600;
  const auto seconds = galilean::seconds_of(text);
  if (!seconds) return seconds.error();
  if (seconds.value() < 1 || seconds.value() > kLongest_s)
    return Error{"a token is valid for at least 1s and at most 100 years"};
  target_s = seconds.value();
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  auto data_folder = default_data_folder();
  NamedToken wanted;
  std::string role(role_of(wanted.right)), revoked;
  double expires_after_s = 0;
  bool list_as_json = false;
  galilean::CommandLine app("Gives people tokens for a monitor, and takes them back.", kCommand);
  app.require_command();
  app.share_options();
  app.option("--data", data_folder, "the monitor's data folder").names_folder();
  auto adding = app.command("add", "give somebody a token, which is printed only once");
  adding.option("name", wanted.name, "whose it is, as 'tokens list' shows it").required();
  adding.option("--role", role, "a viewer watches, an operator steers, too")
      .one_of({"viewer", "operator"})
      .show_default();
  adding.option(
      "--expires", [&](const std::string& text) { return read_expiry(text, expires_after_s); },
      "how long it is valid, such as 8h; without it, until it is revoked");
  auto listing = app.command("list", "list the tokens' names, roles and times");
  listing.flag("--json", list_as_json, "as JSON");
  auto revoking = app.command("revoke", "make a token invalid, at once");
  revoking.option("name", revoked, "whose it is").required();
  if (const auto code = app.parse(argc, argv)) return *code;
  wanted.right = role == role_of(Right::kOperate) ? Right::kOperate : Right::kRead;
  if (adding.chosen()) return add(data_folder, wanted, expires_after_s);
  if (listing.chosen()) return list(data_folder, list_as_json);
  return revoke(data_folder, revoked);
}
