// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/tokens.h"

#include <sstream>

#include "core/private_file.h"
#include "core/regular_file.h"
#include "core/state_folder.h"
#include "monitor/access/digest.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kFileTokenBytes = 20;
constexpr mode_t kOwnersFile = 0600;

Result<std::string> read_or_make(const fs::path& file, bool& is_new) {
  std::error_code unknown;
  if (!fs::exists(file, unknown)) {
    const auto token = random_token(kFileTokenBytes);
    if (!token) return token.error();
    if (const auto written = write_new_file(file, token.value() + "\n", kOwnersFile); !written)
      return Error{written.error().message + "; name a folder that can be written with --data DIR"};
    is_new = true;
  }
  return read_token(file);
}

}  // namespace

fs::path default_data_folder() {
  return state_folder();
}

fs::path operator_token_file(const fs::path& data_folder) {
  return data_folder / "operator.token";
}

Result<Tokens> open_tokens(const fs::path& data_folder) {
  (void)make_private_folder(data_folder);  // what fails is said when a token is written
  Tokens tokens;
  auto viewer = read_or_make(data_folder / "viewer.token", tokens.are_new);
  if (!viewer) return viewer.error();
  auto operator_ = read_or_make(operator_token_file(data_folder), tokens.are_new);
  if (!operator_) return operator_.error();
  tokens.viewer = std::move(viewer).value();
  tokens.operator_ = std::move(operator_).value();
  return tokens;
}

Result<std::string> read_token(const fs::path& file) {
  constexpr std::size_t kShortest = 16, kMostBytes = 4096;
  const auto text = read_regular_file(file.string(), kMostBytes);
  if (!text) return Error{file.string() + " cannot be read: " + text.error().message};
  std::string token;
  std::istringstream(text.value()) >> token;
  if (token.size() < kShortest)
    return Error{file.string() + " has no token; remove it, and the monitor makes a new one"};
  return token;
}

}  // namespace galilean::monitor
