// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/trial/trial.h"

#include <fcntl.h>
#include <unistd.h>

#include <boost/asio/post.hpp>
#include <chrono>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/cut_text.h"
#include "core/json_text.h"
#include "core/private_file.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;

/// So much of what a simulator says is told.
constexpr std::size_t kMostSaidBytes = 8192;

std::string content(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool write_file(const fs::path& file, const std::string& text) {
  if (!make_private_folder(file.parent_path())) return false;
  const auto opened = open_private_file(file, O_WRONLY | O_TRUNC);
  if (!opened) return false;
  const bool is_written = write_all(opened.value(), text);
  return close(opened.value()) == 0 && is_written;
}

/// Returns the place of a program's file. A program's paths are relative to its main file's folder
/// and may lead out of it, so that folder stands deep below `folder`, which no path can leave.
fs::path below(const fs::path& folder, const std::string& path) {
  fs::path result = folder / "in" / "a" / "deep" / "folder";
  for (const auto& part : fs::path(path).relative_path())
    result = part == ".." ? (result == folder ? result : result.parent_path()) : result / part;
  return result;
}

std::string who_cannot_be_tried(bool is_next) {
  return is_next ? "the program cannot be tried: " : "the program that runs now cannot be tried: ";
}

/// Returns how a simulator ended that said nothing.
std::string ending_of(int exit_code) {
  constexpr int kBySignal = 128;
  if (exit_code <= kBySignal)
    return "the simulator ended with exit code " + std::to_string(exit_code);
  return "the simulator crashed (signal " + std::to_string(exit_code - kBySignal) + ")";
}

}  // namespace

Trial::Trial(boost::asio::io_context& io, fs::path simulator, fs::path folder, TrialOrder order,
             Done done)
    : io_(io),
      simulator_(std::move(simulator)),
      folder_(std::move(folder)),
      order_(std::move(order)),
      done_(std::move(done)) {
  for (int seed = 1; seed <= order_.seeds; ++seed) {
    if (!order_.now.empty()) waiting_.push_back({.is_next = false, .seed = seed});
    waiting_.push_back({.is_next = true, .seed = seed});
  }
  all_ = waiting_.size();
  boost::asio::post(io_, [this, alive = alive_] {
    if (*alive) attempt([this] { begin(); });
  });
}

template <class Work>
void Trial::attempt(Work work) try {
  work();
} catch (const std::exception& error) {
  fail(error.what());
}

void Trial::begin() {
  if (const auto written = write_files(); !written) return fail(written.error().message);
  start_pending();
}

Trial::~Trial() {
  *alive_ = false;
  running_.clear();
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Result<void> Trial::write_files() const {
  bool written = write_file(folder_ / "start.json", json_text(order_.situation));
  for (const auto& file : order_.now)
    written = written && write_file(below(folder_ / "now", file.path), file.text);
  for (const auto& file : order_.next)
    written = written && write_file(below(folder_ / "next", file.path), file.text);
  if (!written) return Error{"nothing can be written to " + folder_.string()};
  return {};
}

fs::path Trial::program_file(bool is_next) const {
  const auto& files = is_next ? order_.next : order_.now;
  return below(folder_ / (is_next ? "next" : "now"), files.front().path);
}

fs::path Trial::output(const Run& run, const char* extension) const {
  return folder_ / ((run.is_next ? "next-" : "now-") + std::to_string(run.seed) + extension);
}

std::vector<std::string> Trial::command(const Run& run) const {
  return {simulator_.string(),
          "--headless",
          "--json",
          "--scenario",
          order_.scenario,
          "--start",
          (folder_ / "start.json").string(),
          "--seed",
          std::to_string(run.seed),
          "--duration",
          json_text(nlohmann::json(order_.duration_s)),
          "--bhdl",
          program_file(run.is_next).string()};
}

void Trial::start_pending() {
  while (running_.size() < kAtOnce && !waiting_.empty()) {
    running_.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
    const auto run = std::prev(running_.end());
    auto process = ChildProcess::start(io_, command(*run), output(*run, ".json"),
                                       output(*run, ".err"), [this, run](int exit_code) {
                                         const Run over = std::move(*run);
                                         running_.erase(run);
                                         attempt([&] { take(over, exit_code); });
                                       });
    if (!process) return fail(process.error().message);
    run->process = std::move(process).value();
    end_in_time(*run);
  }
  if (running_.empty()) finish(figures());
}

void Trial::end_in_time(Run& run) {
  const double most_s = order_.duration_s + order_.patience_s;
  run.patience = std::make_unique<boost::asio::steady_timer>(
      io_,
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::duration<double>(most_s)));
  run.patience->async_wait(
      [this, is_next = run.is_next, most_s,
       under_way = std::weak_ptr<bool>(run.is_under_way)](boost::system::error_code error) {
        if (error || under_way.expired()) return;
        attempt([&] {
          fail(who_cannot_be_tried(is_next) + "a run of it hangs: it did not end within " +
               json_text(nlohmann::json(most_s)) + " s");
        });
      });
}

void Trial::take(const Run& run, int exit_code) {
  auto report = read_json(content(output(run, ".json")));
  if (exit_code != 0 || !report || !report.value().is_object()) {
    auto said = content(output(run, ".err"));
    while (said.ends_with('\n')) said.pop_back();
    if (said.empty()) said = ending_of(exit_code);
    return fail(who_cannot_be_tried(run.is_next) + std::string(cut_text(said, kMostSaidBytes)));
  }
  (run.is_next ? next_ : now_).push_back(std::move(report).value());
  ++finished_;
  start_pending();
}

void Trial::fail(std::string why) {
  finish(Error{std::move(why)});
}

void Trial::finish(Result<TrialFigures> result) {
  waiting_.clear();
  running_.clear();
  if (const auto done = std::exchange(done_, nullptr)) done(std::move(result));
}

Result<TrialFigures> Trial::figures() const {
  TrialFigures figures{.now = {}, .next = {}, .duration_s = order_.duration_s};
  auto next = side_of(next_);
  if (!next) return next.error();
  figures.next = std::move(next).value();
  auto now = side_of(now_);
  if (!now) return now.error();
  figures.now = std::move(now).value();
  return figures;
}

}  // namespace galilean::monitor
