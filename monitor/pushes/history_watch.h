// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <optional>
#include <string>

#include "core/clock.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"
#include "monitor/background/worker.h"
#include "monitor/pushes/history/history.h"

namespace galilean::monitor {

/// Looks after the history: whether its chain is whole, once at the start, and whether its disk can
/// be written, more than twice a second. What is wrong is told on /diagnostics, too, for whoever
/// watches without the monitor's page.
///
/// Lives on the io_context's thread.
class HistoryWatch {
 public:
  struct Parts {
    boost::asio::io_context& io;
    Worker& worker;
    Worker& sender;    ///< never waits for the disk
    History& history;  ///< only the worker's thread uses it
    const Clock& clock;
  };

  HistoryWatch(const Parts& parts, wire::Participant& participant);

  /// Returns what is wrong with the history or its disk, in one sentence; empty: nothing is.
  [[nodiscard]] std::string problem() const;
  /// Returns whether pushes can be kept, as far as is known.
  [[nodiscard]] bool is_disk_well() const { return disk_problem().empty(); }
  [[nodiscard]] const History::Disk& disk() const noexcept { return disk_; }
  /// Returns the result of the verification; nothing before it is done, or if it failed.
  [[nodiscard]] const std::optional<Verification>& verification() const noexcept {
    return verification_;
  }

 private:
  void verify();
  void look();
  void see(History::Disk disk);
  void tell();
  [[nodiscard]] std::string disk_problem() const;

  Parts parts_;
  wire::Writer<msg::DiagnosticArray> diagnostics_;
  boost::asio::steady_timer timer_;
  History::Disk disk_;
  std::optional<Verification> verification_;
  std::string unreadable_;    ///< why the history could not be verified
  Time looked_;               ///< when the disk answered last
  bool is_looking_ = false;   ///< the disk was asked, and has not answered
  std::string told_problem_;  ///< the one that was logged last
};

}  // namespace galilean::monitor
