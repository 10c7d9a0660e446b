// SPDX-License-Identifier: BSD-3-Clause
#include "robot/watch/program_watch.h"

#include <poll.h>

#include "bhdl/check.h"
#include "bhdl/source/sha256.h"
#include "robot/executive/turn.h"
#include "robot/log/log.h"

namespace galilean::robot {
namespace {

constexpr int kForEver = -1;
constexpr int kLookAgain_ms = 50;

}  // namespace

ProgramWatch::ProgramWatch(std::filesystem::path file, const Catalog& catalog, Executive& executive,
                           Tell tell)
    : file_(std::move(file)), vocabulary_(catalog), executive_(executive), tell_(std::move(tell)) {
  auto files = bhdl::check_file(file_, vocabulary_).files;
  const std::string first_hash = bhdl::program_hash(files);
  while (watch(files)) files = bhdl::check_file(file_, vocabulary_).files;
  saved_ = bhdl::program_hash(files) != first_hash;
  worker_ = Worker([this](const std::stop_token& stop) { look(stop); },
                   [this](const std::string& failure) { note_failure(failure); });
}

void ProgramWatch::look(const std::stop_token& stop) {
  tell_problem();
  const std::stop_callback ring(stop, [this] { wake_.ring(); });
  if (!saved_) wait();
  saved_ |= files_.take();
  if (!saved_) return;
  saved_ = reload();
}

void ProgramWatch::note_failure(const std::string& failure) {
  failure_ = failure.empty() ? ""
                             : file_.string() + " was saved, but could not be loaded (" + failure +
                                   "). The robot tries again. Check the cause.";
  tell_problem();
}

void ProgramWatch::tell_problem() {
  std::string problem = failure_.empty() ? files_.problem() : failure_;
  if (problem == told_) return;
  tell_(problem);
  told_ = std::move(problem);
}

void ProgramWatch::wait() const {
  pollfd events[] = {{files_.descriptor(), POLLIN, 0}, {wake_.descriptor(), POLLIN, 0}};
  poll(events, 2, files_.folder_missing() ? kLookAgain_ms : kForEver);
}

bool ProgramWatch::reload() {
  auto first = bhdl::check_file(file_, vocabulary_, bhdl::Depth::kErrors);
  const std::string taken_over = first.program ? first.program->hash : std::string();
  if (first.program) swap(std::move(*first.program));
  static_cast<void>(watch(first.files));
  auto whole = bhdl::check_file(file_, vocabulary_);
  const bool read_too_early = watch(whole.files);
  for (const auto& diagnostic : whole.diagnostics) log_warning(format(diagnostic));
  if (!whole.program)
    log_error(file_.string() + " was saved with errors; the program that ran before goes on");
  else if (whole.program->hash != taken_over)
    swap(std::move(*whole.program));
  return read_too_early;
}

bool ProgramWatch::watch(const std::vector<bhdl::SourceFile>& sources) {
  std::vector<std::filesystem::path> files{file_};
  for (const auto& source : sources) files.push_back(file_.parent_path() / source.path);
  return files_.add(files);
}

void ProgramWatch::swap(bhdl::Program program) {
  const std::string hash = program.hash;
  if (!wait_for_turn(executive_))
    return log_error(file_.string() + " was saved, but the control loop stands still");
  // Only now: before its turn, the same program may have been on its way in.
  if (runs(hash)) return;
  if (const auto loaded = executive_.load(std::move(program)); !loaded)
    log_error(file_.string() + " was saved, but cannot run: " + loaded.error().message);
  else
    log_info(file_.string() + " (" + hash.substr(0, 8) + ") was saved and takes over");
}

bool ProgramWatch::runs(const std::string& hash) const {
  const auto running = executive_.description(executive_.running());
  return running && running->program.hash == hash;
}

}  // namespace galilean::robot
