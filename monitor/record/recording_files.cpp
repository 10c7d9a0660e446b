// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recording_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace galilean::monitor {

namespace fs = std::filesystem;

void add(RecordingFiles::Totals& totals, const mcap::Writer& writer) noexcept {
  const auto& statistics = writer.statistics();
  totals.bytes += writer.bytes_written();
  if (statistics.messages == 0) return;
  const bool first = totals.messages == 0;
  totals.start_ns = first ? statistics.start_ns : std::min(totals.start_ns, statistics.start_ns);
  totals.end_ns = std::max(totals.end_ns, statistics.end_ns);
  totals.messages += statistics.messages;
}

Result<void> RecordingFiles::begin(std::int64_t now_ns) {
  const std::string path = path_of(ended_.files);
  auto sink = mcap::FileSink::create(path, plan_.replace);
  if (!sink) return sink.error();
  auto file = std::make_unique<File>(path, std::move(sink).value(), plan_.library);
  file->began_ns = now_ns;
  if (auto done = file->writer.begin(); !done) return done;
  file_ = std::move(file);
  kept_.push_back(path);
  delete_oldest();
  return {};
}

Result<void> RecordingFiles::end() {
  if (!file_) return {};
  auto done = file_->writer.end();
  if (done) done = file_->sink.sync();
  add(ended_, file_->writer);
  ++ended_.files;
  file_.reset();
  return done;
}

bool RecordingFiles::is_full(std::int64_t now_ns) const noexcept {
  if (!file_) return false;
  if (plan_.split_bytes > 0 && file_->writer.bytes_written() >= plan_.split_bytes) return true;
  return plan_.split_span > Duration{} && now_ns - file_->began_ns >= plan_.split_span.count();
}

RecordingFiles::Totals RecordingFiles::totals() const noexcept {
  Totals totals = ended_;
  if (!file_) return totals;
  add(totals, file_->writer);
  ++totals.files;
  return totals;
}

std::string RecordingFiles::name() const {
  const std::size_t files = totals().files;
  if (files <= 1) return path_of(0);
  return path_of(files - std::min(files, kept_.size())) + " to " + path_of(files - 1);
}

/// A recording of one file has the name that was asked for.
std::string RecordingFiles::path_of(std::size_t number) const {
  if (!is_split() && number == 0) return plan_.out;
  const fs::path out(plan_.out);
  const std::string name = out.stem().string() + "_" + std::to_string(number);
  return (out.parent_path() / (name + out.extension().string())).string();
}

void RecordingFiles::delete_oldest() {
  while (plan_.most_files > 0 && kept_.size() > plan_.most_files) {
    std::error_code gone_already;
    fs::remove(kept_.front(), gone_already);
    kept_.pop_front();
  }
}

}  // namespace galilean::monitor
