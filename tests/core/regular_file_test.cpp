// SPDX-License-Identifier: BSD-3-Clause
#include "core/regular_file.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "tests/temporary_folder.h"

namespace galilean {
namespace {

/// Makes a socket that has a name.
void make_socket(const std::string& path) {
  const int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  EXPECT_EQ(bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  close(descriptor);
}

TEST(RegularFile, IsReadWhole) {
  const TemporaryFolder folder;
  const auto path = (folder / "text").string();
  std::ofstream(path, std::ios::binary) << std::string(100'000, 'x');
  EXPECT_EQ(read_regular_file(path, 100'000).value().size(), 100'000U);
  EXPECT_EQ(read_regular_file(path, 99'999).error().message, "it has more than 99999 bytes");
}

TEST(RegularFile, WhatIsNoneIsNamedAndNobodyWaits) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("pipe", folder / "link");
  make_socket((folder / "socket").string());
  const std::map<std::string, std::string> kinds{{(folder / "pipe").string(), "a pipe"},
                                                 {(folder / "link").string(), "a pipe"},
                                                 {(folder / "socket").string(), "a socket"},
                                                 {folder.path().string(), "a folder"},
                                                 {"/dev/zero", "a device"}};
  for (const auto& [path, kind] : kinds) {
    EXPECT_EQ(open_regular_file(path).error().message, "it is " + kind + ", and no file") << path;
    EXPECT_FALSE(read_regular_file(path, 10).ok()) << path;
  }
  EXPECT_EQ(open_regular_file((folder / "nothing").string()).error().message,
            "No such file or directory");
}

}  // namespace
}  // namespace galilean
