// SPDX-License-Identifier: BSD-3-Clause
// serial_mutator BOARD LINK: stands in the serial line between a board, BOARD, and a robot, for
// which it makes a pseudo-terminal behind LINK. It does to the bytes what the lines of its standard
// input say, and ends with that input:
//   pass                 they go through
//   cut                  they are lost, and the cable seems to be there
//   drop N, garble N     of a thousand, N are lost, or have one bit wrong
//   halve                each piece comes in two halves, 4 ms apart
//   restart              the board is silent for 300 ms; then it tells another boot, and counts
//   from 0 unplug               the device is gone, until one of the others is asked for
// It answers each line, and tells each status of the board, as a line of JSON.
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <deque>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "robot/firmware/messages.h"

namespace {

using namespace galilean::robot::firmware;
using Bytes = std::vector<std::uint8_t>;
using Clock = std::chrono::steady_clock;
constexpr auto kBetweenHalves = std::chrono::milliseconds(4);
constexpr auto kBooting = std::chrono::milliseconds(300);

double wall_ms() {
  using namespace std::chrono;
  return duration<double, std::milli>(system_clock::now().time_since_epoch()).count();
}

termios raw_line() {
  termios raw{};
  cfmakeraw(&raw);
  cfsetspeed(&raw, B115200);
  return raw;
}

/// What is done to the bytes of both directions.
struct Mode {
  std::string name = "pass";
  unsigned per_mille = 0;
};

/// One direction of the line. Pieces that wait are written when they are due.
class Direction {
 public:
  void take(Bytes piece, const Mode& mode) {
    if (mode.name == "cut" || mode.name == "unplug") return;
    if (mode.name == "drop") std::erase_if(piece, [&](auto) { return hits(mode.per_mille); });
    if (mode.name == "garble")
      for (auto& byte : piece)
        if (hits(mode.per_mille)) byte ^= static_cast<std::uint8_t>(1U << (random_() % 8));
    const auto now = Clock::now();
    const auto middle = static_cast<std::ptrdiff_t>(mode.name == "halve" ? piece.size() / 2 : 0);
    if (middle > 0) waiting_.push_back({now, Bytes(piece.begin(), piece.begin() + middle)});
    const auto due = middle > 0 ? now + kBetweenHalves : now;
    waiting_.push_back({due, Bytes(piece.begin() + middle, piece.end())});
  }
  /// Writes what is due to `file`. What that does not take is lost, as on a line that nobody reads.
  void pass_on(int file) {
    for (; !waiting_.empty() && waiting_.front().due <= Clock::now(); waiting_.pop_front()) {
      const Bytes& bytes = waiting_.front().bytes;
      if (file >= 0 && write(file, bytes.data(), bytes.size()) < 0) continue;
    }
  }

 private:
  struct Piece {
    Clock::time_point due;
    Bytes bytes;
  };
  bool hits(unsigned per_mille) { return random_() % 1000 < per_mille; }

  std::deque<Piece> waiting_;
  std::minstd_rand random_{1};
};

/// Tells what a board reports, and lets it seem to have been restarted.
class Reports {
 public:
  void restart() {
    ++boots_;
    silent_until_ = Clock::now() + kBooting;
    is_first_ = true;
  }
  /// Returns what the robot is to hear instead of `bytes`.
  Bytes heard(const Bytes& bytes) {
    Bytes frames;
    for (const auto byte : bytes)
      if (decoder_.push(byte)) add(decoder_.frame(), frames);
    if (Clock::now() < silent_until_) return {};
    return boots_ > 0 ? frames : bytes;
  }

 private:
  void add(const Frame& frame, Bytes& frames) {
    std::array<std::uint8_t, kMaxEncoded> encoded{};
    std::size_t size = 0;
    Status status;
    HelloReply reply;
    if (frame.type == static_cast<std::uint8_t>(MessageType::kStatus) && unpack(frame, status)) {
      tell(status);
      size = encode_message(since_boot(status), frame.sequence, encoded);
    } else if (frame.type == static_cast<std::uint8_t>(MessageType::kHelloReply) &&
               unpack(frame, reply)) {
      reply.boot_count = static_cast<std::uint16_t>(reply.boot_count + boots_);
      reply.uptime_ms -= first_.uptime_ms;
      size = encode_message(reply, frame.sequence, encoded);
    } else {
      size = encode(frame, encoded);
    }
    frames.insert(frames.end(), encoded.begin(),
                  encoded.begin() + static_cast<std::ptrdiff_t>(size));
  }
  Status since_boot(Status status) {
    if (is_first_ && boots_ > 0) first_ = status;
    is_first_ = false;
    status.boot_count = static_cast<std::uint16_t>(status.boot_count + boots_);
    status.uptime_ms -= first_.uptime_ms;
    status.left_encoder_counts -= first_.left_encoder_counts;
    status.right_encoder_counts -= first_.right_encoder_counts;
    return status;
  }
  static void tell(const Status& status) {
    std::ostringstream line;
    line << std::fixed << "{\"at_ms\":" << wall_ms() << ",\"left\":" << status.left_speed_counts_s
         << ",\"right\":" << status.right_speed_counts_s << ",\"flags\":" << int{status.flags}
         << ",\"rejected\":" << status.rejected_frames << "}\n";
    std::cout << line.str() << std::flush;
  }

  FrameDecoder decoder_;
  unsigned boots_ = 0;
  bool is_first_ = false;
  Status first_;  ///< after the newest restart
  Clock::time_point silent_until_{};
};

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
      to_board_.take(bytes_from(robot_.file()), mode_);
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
  Reports reports_;
  Direction to_robot_;
  Direction to_board_;
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
