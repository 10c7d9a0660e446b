// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <random>
#include <string>
#include <vector>

namespace galilean::faults {

using Bytes = std::vector<std::uint8_t>;

/// What is done to the bytes of both directions.
struct Mode {
  std::string name = "pass";
  unsigned per_mille = 0;
};

/// One direction of the line. Pieces that wait are written when they are due.
class MutatedDirection {
 public:
  void take(Bytes piece, const Mode& mode) {
    if (mode.name == "cut" || mode.name == "unplug") return;
    if (mode.name == "drop") std::erase_if(piece, [&](auto) { return hits(mode.per_mille); });
    if (mode.name == "garble")
      for (auto& byte : piece)
        if (hits(mode.per_mille)) byte ^= static_cast<std::uint8_t>(1U << (random_() % 8));
    if (piece.empty()) return;
    const auto now = Stopwatch::now();
    const auto middle = static_cast<std::ptrdiff_t>(mode.name == "halve" ? piece.size() / 2 : 0);
    if (middle > 0) waiting_.push_back({now, Bytes(piece.begin(), piece.begin() + middle)});
    const auto due = middle > 0 ? now + kBetweenHalves : now;
    waiting_.push_back({due, Bytes(piece.begin() + middle, piece.end())});
  }
  /// Writes what is due to `file`, or nowhere if that is -1. What is not taken is lost, as on a
  /// line that nobody reads.
  void pass_on(int file) {
    for (; !waiting_.empty() && waiting_.front().due <= Stopwatch::now(); waiting_.pop_front()) {
      const Bytes& bytes = waiting_.front().bytes;
      [[maybe_unused]] const auto taken = write(file, bytes.data(), bytes.size());
    }
  }

 private:
  using Stopwatch = std::chrono::steady_clock;
  static constexpr auto kBetweenHalves = std::chrono::milliseconds(4);
  struct Piece {
    Stopwatch::time_point due;
    Bytes bytes;
  };
  bool hits(unsigned per_mille) { return random_() % 1000 < per_mille; }

  std::deque<Piece> waiting_;
  std::minstd_rand random_{1};
};

}  // namespace galilean::faults
