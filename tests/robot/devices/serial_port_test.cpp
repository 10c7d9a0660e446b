// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/serial_port.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>

#include "tests/temporary_folder.h"

namespace galilean::robot {
namespace {

using std::chrono::milliseconds;
using std::string_literals::operator""s;

/// The other end of a serial line: the master of a pseudo-terminal, reached by a link that stays.
class Board {
 public:
  explicit Board(const std::filesystem::path& link) : link_(link) {
    master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    grantpt(master_);
    unlockpt(master_);
    std::filesystem::remove(link_);
    std::filesystem::create_symlink(ptsname(master_), link_);
  }
  ~Board() {
    close(master_);
    std::filesystem::remove(link_);
  }
  void send(const std::string& bytes) { (void)!write(master_, bytes.data(), bytes.size()); }
  std::string receive() {
    pollfd wait{master_, POLLIN, 0};
    if (poll(&wait, 1, 1000) <= 0) return "";
    std::array<char, 256> bytes;
    const auto count = ::read(master_, bytes.data(), bytes.size());
    return count > 0 ? std::string(bytes.data(), static_cast<std::size_t>(count)) : "";
  }

 private:
  std::filesystem::path link_;
  int master_ = -1;
};

class SerialLine : public testing::Test {
 protected:
  std::string read() {
    std::array<std::uint8_t, 256> bytes;
    const auto count = port.read(bytes);
    return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count)};
  }
  std::size_t write(const std::string& text) {
    return port.write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }
  void maintain() { port.maintain(now += milliseconds(600)); }

  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "line";
  SerialPort port{path, 115200};
  Time now{};
};

TEST_F(SerialLine, EveryByteGoesThroughAsItIsBothWays) {
  Board board(path);
  maintain();
  ASSERT_TRUE(port.is_open()) << port.problem();
  const std::string all("\x00\x03\x04\x0d\x0a\x11\x13\x1a\x7f\xff", 10);
  board.send(all);
  EXPECT_EQ(read(), all);
  EXPECT_EQ(read(), "");
  EXPECT_TRUE(port.is_open());
  EXPECT_EQ(write(all), all.size());
  EXPECT_EQ(board.receive(), all);
}

TEST_F(SerialLine, AMissingDeviceIsNamedAndFoundWhenItComes) {
  maintain();
  EXPECT_FALSE(port.is_open());
  EXPECT_NE(port.problem().find(path.string()), std::string::npos) << port.problem();
  EXPECT_NE(port.problem().find("plug"), std::string::npos) << port.problem();
  EXPECT_EQ(write("x"), 0u);
  EXPECT_EQ(read(), "");
  Board board(path);
  maintain();
  EXPECT_TRUE(port.is_open());
  EXPECT_EQ(port.problem(), "");
}

TEST_F(SerialLine, ALineThatIsHungUpIsLostAndComesBack) {
  {
    Board board(path);
    maintain();
    ASSERT_TRUE(port.is_open());
  }
  EXPECT_EQ(read(), "");
  EXPECT_FALSE(port.is_open());
  EXPECT_NE(port.problem().find("lost"), std::string::npos) << port.problem();
  Board board(path);
  maintain();
  ASSERT_TRUE(port.is_open());
  board.send("again");
  EXPECT_EQ(read(), "again");
}

TEST_F(SerialLine, AFullLineTakesWhatItCanAndDoesNotWait) {
  Board board(path);
  maintain();
  const std::string much(1000, 'x');
  std::size_t taken = 0;
  for (int i = 0; i < 100; ++i) taken += write(much);
  EXPECT_LT(taken, 100000u);
  EXPECT_TRUE(port.is_open());
}

TEST_F(SerialLine, ALineThatAnotherRobotUsesIsLeftToIt) {
  Board board(path);
  maintain();
  SerialPort second(path, 115200);
  second.maintain(now);
  EXPECT_FALSE(second.is_open());
  EXPECT_NE(second.problem().find("another process"), std::string::npos) << second.problem();
}

TEST_F(SerialLine, APathThatCanBeNoDeviceIsNamedWithWhatToDo) {
  for (const std::string& bad :
       {folder.path().string(), std::string(300, 'x'), "/dev/null/none"s}) {
    SerialPort wrong(bad, 115200);
    wrong.maintain(now);
    EXPECT_NE(wrong.problem().find(bad + " cannot be opened"), std::string::npos)
        << wrong.problem();
    EXPECT_NE(wrong.problem().find("name a serial device"), std::string::npos) << wrong.problem();
  }
}

TEST_F(SerialLine, WhatIsNoSerialLineIsNamed) {
  SerialPort file("/dev/null", 115200);
  file.maintain(now);
  EXPECT_FALSE(file.is_open());
  EXPECT_NE(file.problem().find("is not a serial line"), std::string::npos) << file.problem();
  Board board(path);
  SerialPort odd(path, 12345);
  odd.maintain(now);
  EXPECT_NE(odd.problem().find("12345 baud"), std::string::npos) << odd.problem();
}

}  // namespace
}  // namespace galilean::robot
