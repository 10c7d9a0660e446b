// SPDX-License-Identifier: BSD-3-Clause
#include "core/non_blocking_log.h"

#include <poll.h>
#include <unistd.h>

#include <string>
#include <string_view>

#include "core/cut_text.h"

namespace galilean {
namespace {

/// What a thread has written of its line. Lines of threads that write at the same time stay whole.
std::string& line_of_thread() {
  static thread_local std::string line;
  return line;
}

}  // namespace

NonBlockingLog::NonBlockingLog(int descriptor, std::ostream& stream)
    : descriptor_(descriptor), stream_(stream), before_(stream.rdbuf(this)) {}

NonBlockingLog::~NonBlockingLog() {
  stream_.rdbuf(before_);
}

NonBlockingLog::int_type NonBlockingLog::overflow(int_type letter) {
  if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
  const char one = traits_type::to_char_type(letter);
  add(&one, 1);
  return letter;
}

std::streamsize NonBlockingLog::xsputn(const char* text, std::streamsize count) {
  add(text, static_cast<std::size_t>(count));
  return count;
}

void NonBlockingLog::add(const char* text, std::size_t count) {
  std::string& line = line_of_thread();
  std::string_view rest(text, count);
  for (std::size_t end; (end = rest.find('\n')) != rest.npos; rest.remove_prefix(end + 1)) {
    line.append(rest.substr(0, end));
    write_line(line);
    line.clear();
  }
  line.append(rest);
}

void NonBlockingLog::write_line(std::string_view line) {
  const std::lock_guard lock(mutex_);
  if (dropped_ > 0) {
    if (!write_whole("(" + std::to_string(dropped_) +
                     " lines are missing here: nobody took them)\n")) {
      ++dropped_;
      return;
    }
    dropped_ = 0;
  }
  if (!write_whole(std::string(cut_text(line, kMostLineBytes - 1)) + "\n")) ++dropped_;
}

/// A pipe that is writable takes kMostLineBytes without a wait. The mutex keeps other threads from
/// filling it in between.
bool NonBlockingLog::write_whole(std::string_view text) const {
  pollfd out{descriptor_, POLLOUT, 0};
  if (poll(&out, 1, 0) != 1 || (out.revents & POLLOUT) == 0) return false;
  return ::write(descriptor_, text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

}  // namespace galilean
