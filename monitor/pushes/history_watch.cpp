// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history_watch.h"

#include <cmath>
#include <iostream>
#include <utility>

#include "core/wire/topic_names.h"
#include "monitor/background/guarded.h"
#include "monitor/team/monitor_status.h"

namespace galilean::monitor {
namespace {

/// What a look finds is told at once, so that it is told within half a second.
constexpr auto kLookAtDiskEach = std::chrono::milliseconds(400);
/// A disk that has not answered for so long is told of. What else the same thread does takes less.
constexpr Duration kDiskPatience = std::chrono::seconds(3);

}  // namespace

HistoryWatch::HistoryWatch(const Parts& parts, wire::Participant& participant)
    : parts_(parts),
      diagnostics_(participant, wire::kDiagnosticsTopic),
      timer_(parts.io),
      looked_(parts.clock.now()) {
  verify();
  look();
}

void HistoryWatch::verify() {
  const auto failed = [this](const std::string& why) { unreadable_ = why; };
  parts_.worker.run([this] { return parts_.history.verify(); },
                    [this, failed](Result<Verification> found) {
                      if (!found) return failed(found.error().message);
                      verification_ = std::move(found).value();
                      if (verification_->broken)
                        std::clog << "galilean-monitor: " << in_words(*verification_) << std::endl;
                    },
                    failed);
}

void HistoryWatch::look() {
  if (!std::exchange(is_looking_, true))
    parts_.worker.run([this] { return parts_.history.check_disk(); },
                      [this](History::Disk disk) { see(std::move(disk)); },
                      [this](const std::string& why) {
                        auto disk = disk_;
                        disk.problem = why;
                        see(std::move(disk));
                      });
  (void)guarded("telling of the history", [this] { tell(); });
  timer_.expires_after(kLookAtDiskEach);
  timer_.async_wait([this](boost::system::error_code error) {
    if (!error) look();
  });
}

void HistoryWatch::see(History::Disk disk) {
  disk_ = std::move(disk);
  looked_ = parts_.clock.now();
  is_looking_ = false;
  if (problem() != told_problem_) tell();
}

std::string HistoryWatch::disk_problem() const {
  const double waiting_s = to_seconds(parts_.clock.now() - looked_);
  if (is_looking_ && waiting_s > to_seconds(kDiskPatience))
    return "the disk of the history has not answered for " +
           std::to_string(std::lround(std::ceil(waiting_s))) + " s";
  return disk_.problem;
}

std::string HistoryWatch::problem() const {
  if (const auto disk = disk_problem(); !disk.empty())
    return "The history of pushes is in danger: " + disk + ".";
  if (!unreadable_.empty()) return "The history of pushes cannot be read: " + unreadable_ + ".";
  if (verification_ && verification_->broken) return in_words(*verification_);
  return {};
}

void HistoryWatch::tell() {
  const auto now = problem();
  if (now != told_problem_) {
    const bool is_logged = verification_ && now == in_words(*verification_);
    if (!is_logged)
      std::clog << "galilean-monitor: " << (now.empty() ? "The history can be written again." : now)
                << std::endl;
    told_problem_ = now;
  }
  parts_.sender.run(
      [this, message = monitor_status(kHistoryStatusName, now, "The history can be written.")] {
        (void)diagnostics_.write(message);
      });
}

}  // namespace galilean::monitor
