// SPDX-License-Identifier: BSD-3-Clause
// serial_mutator BOARD LINK: stands in the serial line between a board, BOARD, and a robot, for
// which it makes a pseudo-terminal behind LINK. It does to the bytes what the lines of its standard
// input say, and ends with that input:
//   pass                 they go through
//   cut                  they are lost, and the cable seems to be there
//   stall                those to the board wait, and come all at once afterwards
//   drop N, garble N     of a thousand, N are lost, or have one bit wrong
//   halve                each piece comes in two halves, 4 ms apart
//   restart              it is silent for 300 ms, then tells another boot and counts from 0
//   unplug               the device is gone, until one of the others is asked for
// It answers each line, and tells each status of the board, as a line of JSON.
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>

#include "tests/faults/board_reports.h"
#include "tests/faults/mutated_direction.h"

namespace {

using namespace galilean::faults;

termios raw_line() {
  termios raw{};
  cfmakeraw(&raw);
  cfsetspeed(&raw, B115200);
  return raw;
}

/// The robot's end of the line.
class RobotEnd {
 public:
  explicit RobotEnd(std::string link) : link_(std::move(link)) {}
  ~RobotEnd() { unplug(); }
  RobotEnd(const RobotEnd&) = delete;
  RobotEnd& operator=(const RobotEnd&) = delete;

  bool plug_in() {
    if (ours_ >= 0) return true;
    std::array<char, 128> device{};
    termios raw = raw_line();
    if (openpty(&ours_, &robots_, device.data(), &raw, nullptr) != 0) return false;
    for (const int file : {ours_, robots_}) fcntl(file, F_SETFD, FD_CLOEXEC);
    fcntl(ours_, F_SETFL, O_NONBLOCK);
    unlink(link_.c_str());
    return symlink(device.data(), link_.c_str()) == 0;
  }
  void unplug() {
    for (int* const file : {&ours_, &robots_}) {
      if (*file >= 0) close(*file);
      *file = -1;
    }
    unlink(link_.c_str());
  }
  [[nodiscard]] int file() const { return ours_; }

 private:
  std::string link_;
  int ours_ = -1;
  int robots_ = -1;
};

Bytes bytes_from(int file) {
  Bytes bytes(512);
  const ssize_t count = file >= 0 ? read(file, bytes.data(), bytes.size()) : 0;
  bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return bytes;
}

/// The line between `board` and the robot, until the standard input ends.
class Mutator {
 public:
  Mutator(int board, RobotEnd& robot) : board_(board), robot_(robot) {}

  void run() {
    while (obey_input()) {
      to_robot_.take(reports_.heard(bytes_from(board_)), mode_);
      if (mode_.name != "stall") to_board_.take(bytes_from(robot_.file()), mode_);
      to_robot_.pass_on(robot_.file());
      to_board_.pass_on(board_);
    }
  }

 private:
  /// Waits a millisecond for orders. Returns false once there will be none.
  bool obey_input() {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, 1) <= 0) return true;
    std::array<char, 256> text{};
    const ssize_t count = read(STDIN_FILENO, text.data(), text.size());
    if (count <= 0) return false;
    given_.append(text.data(), static_cast<std::size_t>(count));
    for (auto end = given_.find('\n'); end != std::string::npos; end = given_.find('\n')) {
      obey(given_.substr(0, end));
      given_.erase(0, end + 1);
    }
    return true;
  }
  void obey(const std::string& line) {
    std::istringstream words(line);
    Mode mode;
    words >> mode.name >> mode.per_mille;
    if (mode.name == "restart") {
      reports_.restart();
      mode = Mode();
    }
    mode_ = mode;
    if (mode_.name == "unplug")
      robot_.unplug();
    else if (!robot_.plug_in())
      std::cerr << "serial_mutator: no pseudo-terminal can be made\n";
    std::ostringstream answer;
    answer << std::fixed << "{\"at_ms\":" << wall_ms() << ",\"obeyed\":\"" << line << "\"}\n";
    std::cout << answer.str() << std::flush;
  }

  int board_;
  RobotEnd& robot_;
  Mode mode_;
  BoardReports reports_;
  MutatedDirection to_robot_;
  MutatedDirection to_board_;
  std::string given_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const int board = open(argv[1], O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  RobotEnd robot(argv[2]);
  if (board < 0 || !robot.plug_in()) {
    std::cerr << "serial_mutator: " << argv[1] << " or " << argv[2] << " cannot be opened\n";
    return 1;
  }
  const termios raw = raw_line();
  tcsetattr(board, TCSANOW, &raw);
  std::cout << "{\"ready\":true}" << std::endl;
  Mutator(board, robot).run();
  close(board);
  return 0;
}
