// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recording_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;

Result<mcap::FileSink> open_sink(const std::string& path, bool replace) {
  if (path == kStandardOutput) return mcap::FileSink::standard_output();
  return mcap::FileSink::create(path, replace);
}

/// Adds what a file holds to what those before it hold.
void add(RecordingFiles::Totals& totals, const mcap::Writer& writer) noexcept {
  const auto& statistics = writer.statistics();
  ++totals.files;
  totals.bytes += writer.bytes_written();
  if (statistics.messages == 0) return;
  const bool first = totals.messages == 0;
  totals.start_ns = first ? statistics.start_ns : std::min(totals.start_ns, statistics.start_ns);
  totals.end_ns = std::max(totals.end_ns, statistics.end_ns);
  totals.messages += statistics.messages;
}

}  // namespace

Result<void> RecordingFiles::begin(Time now) {
  aside_.reset();
  const std::string path = take_path();
  auto sink = open_sink(path, plan_.replace);
  if (!sink) return sink.error();
  auto file = std::make_unique<File>(std::move(sink).value(), plan_);
  file->began = now;
  if (auto done = file->writer.begin(); !done) return done;
  file_ = std::move(file);
  kept_.push_back(path);
  delete_oldest();
  return {};
}

Result<void> RecordingFiles::end() {
  if (!file_) return {};
  auto done = finish(*file_);
  add(ended_, file_->writer);
  file_.reset();
  return done;
}

Result<void> RecordingFiles::set_aside() {
  auto done = finish(*file_);
  add(ended_, file_->writer);
  aside_ = std::move(file_);
  return done;
}

Result<void> RecordingFiles::amend(const mcap::Metadata& metadata) {
  if (auto there = check(); !there) return there;
  mcap::Bytes record;
  append(record, metadata);
  auto& writer = aside_->writer;
  const auto bytes_before = writer.bytes_written();
  // Its index, and lengths that this makes longer.
  constexpr std::uint64_t kMoreThanThat = 1000;
  if (auto done = writer.take_up(record.size() + kMoreThanThat); !done) return done;
  if (auto done = writer.write(metadata); !done) return done;
  auto done = finish(*aside_);
  ended_.bytes += writer.bytes_written() - bytes_before;
  return done;
}

Result<void> RecordingFiles::finish(File& file) {
  auto done = file.writer.end();
  if (done) done = file.sink.sync();
  lost_ = lost_ || !file.sink.check_whole();
  return done;
}

Result<void> RecordingFiles::check() {
  const File* file = newest_file();
  auto done = file ? file->sink.check_whole() : Result<void>();
  lost_ = lost_ || !done;
  return done;
}

bool RecordingFiles::has_moved() const {
  const File* file = newest_file();
  return file && file->sink.has_moved();
}

bool RecordingFiles::is_full(Time now) const noexcept {
  if (!file_) return false;
  if (plan_.split_bytes > 0 && file_->writer.bytes_written() >= plan_.split_bytes) return true;
  return plan_.split_span > Duration{} && now - file_->began >= plan_.split_span;
}

RecordingFiles::Totals RecordingFiles::totals() const noexcept {
  Totals totals = ended_;
  if (file_) add(totals, file_->writer);
  return totals;
}

std::string RecordingFiles::name() const {
  if (plan_.out == kStandardOutput) return "standard output";
  if (kept_.empty()) return plan_.out;
  if (kept_.size() == 1) return kept_.front();
  return kept_.front() + " to " + kept_.back();
}

/// A recording of one file has the name that was asked for.
std::string RecordingFiles::path_of(std::size_t number) const {
  const bool is_split = plan_.split_bytes > 0 || plan_.split_span > Duration{};
  if (plan_.out == kStandardOutput || (!is_split && number == 0)) return plan_.out;
  const fs::path out(plan_.out);
  const std::string name = out.stem().string() + "_" + std::to_string(number);
  return (out.parent_path() / (name + out.extension().string())).string();
}

std::string RecordingFiles::take_path() {
  const bool first = next_ == 0;
  std::string path = path_of(next_++);
  std::error_code unknown;
  while (!first && !plan_.replace && path != kStandardOutput && fs::exists(path, unknown))
    path = path_of(next_++);
  return path;
}

void RecordingFiles::delete_oldest() {
  while (plan_.most_files > 0 && kept_.size() > plan_.most_files) {
    std::error_code gone_already;
    fs::remove(kept_.front(), gone_already);
    kept_.pop_front();
  }
}

}  // namespace galilean::monitor
