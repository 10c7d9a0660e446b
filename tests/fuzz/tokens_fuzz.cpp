// SPDX-License-Identifier: BSD-3-Clause
// Reads random files of named tokens. What is read has a digest and a role that a token can have,
// and gives the right of that role to the bearer of this token alone, until it expires. What is not
// is refused in a sentence that names the file.
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "monitor/access/access.h"
#include "monitor/access/named_tokens.h"
#include "tests/fuzz/input.h"

namespace {

using namespace galilean::monitor;
using galilean::bhdl::must;

constexpr std::int64_t kNow_s = 2'000'000'000;

/// A file of this process, which goes with it.
struct File {
  File()
      : path(std::filesystem::temp_directory_path() /
             ("tokens_" + std::to_string(getpid()) + ".json")) {}
  ~File() {
    std::error_code gone_already;
    std::filesystem::remove(path, gone_already);
  }
  /// Writes the bytes, and keeps others from writing, without which nothing is read.
  void write(const std::uint8_t* data, std::size_t size) const {
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    std::filesystem::permissions(
        path, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  }
  std::filesystem::path path;
};

void check(const std::vector<NamedToken>& tokens) {
  Access access({"a viewer's token", "an operator's token"}, false, [] { return kNow_s; });
  access.set_named(tokens);
  for (const auto& token : tokens) {
    must(token.sha256.size() == 64 &&
             token.sha256.find_first_not_of("0123456789abcdef") == std::string::npos,
         "a digest is one");
    must(token.right == Right::kRead || token.right == Right::kOperate, "a role gives a right");
    must(!role_of(token.right).empty(), "a right has a role");
    // One digest may stand there twice, with two roles.
    const auto gives = [&](const NamedToken& each) {
      return each.sha256 == token.sha256 && !each.is_expired(kNow_s);
    };
    must((access.right_by_digest(token.sha256) != Right::kNone) ==
             std::ranges::any_of(tokens, gives),
         "a token gives a right until it expires");
    must(access.right_by_token(token.sha256) == Right::kNone, "a digest is no token");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const File file;
  file.write(data, size);
  const auto tokens = read_named_tokens(file.path);
  if (tokens)
    check(tokens.value());
  else
    must(tokens.error().message.starts_with(file.path.string()), "an error names its file");
  return 0;
}
