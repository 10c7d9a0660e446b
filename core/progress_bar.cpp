// SPDX-License-Identifier: BSD-3-Clause
#include "core/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/cut_text.h"
#include "core/visible_text.h"

namespace galilean {
namespace {

constexpr std::size_t kBarLetters = 24, kMostOfTask = 40;
/// To the beginning of the line, and what is behind it is deleted.
constexpr const char* kBeginLine = "\r\x1b[K";

bool takes_escapes() {
  const char* terminal = std::getenv("TERM");
  return terminal && *terminal && std::string_view(terminal) != "dumb";
}

}  // namespace

void ProgressBar::show(double done) {
  const Time now = setup_.clock.now();
  if (now < next_) return;
  next_ = now + kShowEach;
  done = std::clamp(done, 0.0, 1.0);
  const auto letters = static_cast<std::size_t>(done * kBarLetters);
  const std::string task = visible(setup_.task);
  setup_.write(kBeginLine + std::string(cut_text(task, kMostOfTask)) + " [" +
               std::string(letters, '#') + std::string(kBarLetters - letters, ' ') + "] " +
               std::to_string(static_cast<int>(done * 100)) + " %");
  is_shown_ = true;
}

void ProgressBar::clear() {
  if (is_shown_) setup_.write(kBeginLine);
  is_shown_ = false;
}

std::unique_ptr<ProgressBar> progress_on_terminal(std::string task, bool prints_meanwhile) {
  static const SteadyClock clock;
  if (isatty(STDERR_FILENO) == 0 || !takes_escapes()) return nullptr;
  if (prints_meanwhile && isatty(STDOUT_FILENO) != 0) return nullptr;
  return std::make_unique<ProgressBar>(
      ProgressBar::Setup{std::move(task), clock, [](const std::string& text) {
                           std::fputs(text.c_str(), stderr);
                           std::fflush(stderr);
                         }});
}

}  // namespace galilean
