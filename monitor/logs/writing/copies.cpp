// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/writing/copies.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <utility>

#include "core/command_line/exit_code.h"
#include "core/plural.h"
#include "core/visible_text.h"
#include "core/written_files.h"
#include "monitor/playback/late_joiner.h"

namespace galilean::logs {
namespace {

constexpr std::size_t kReadingBytes = std::size_t{48} << 20;  // of all recordings together
constexpr std::size_t kLeastBytes = std::size_t{4} << 20;

wire::Delivery delivery_in(const mcap::Summary& summary, std::uint16_t channel) {
  const auto found = summary.channels.find(channel);
  if (found == summary.channels.end()) return wire::Delivery::kStream;
  const auto schema = summary.schemas.find(found->second.schema_id);
  return schema == summary.schemas.end() ? wire::Delivery::kStream
                                         : wire::delivery_of(schema->second.name);
}

/// Returns what is said of so many channels that have no message.
std::string silent_text(std::size_t channels) {
  if (channels == 0) return {};
  return ", of which " + std::to_string(channels) + agreeing(channels, " has", " have") +
         " no message";
}

/// One of the recordings that are copied from, and its next message.
struct CopySource {
  const Recording* recording;
  SelectedMessages messages;
  const mcap::Message* next = nullptr;
};

class Copying {
 public:
  Copying(std::string program, const CopyOptions& options)
      : program_(std::move(program)), options_(options) {}

  int run() {
    auto done = open();
    if (!done) return fail(done.error().message);
    if (is_part() && !earliest()) {
      for (const auto& source : sources_) (void)tell_damage(program_, source.messages);
      return fail(nothing_is_there());
    }
    if (done = create(); !done) return fail(done.error().message);
    done = copy();
    if (!done) return fail(done.error().message + "; what was written until then can be read");
    tell();
    int code = tell_what_is_not_as_asked();
    for (const auto& source : sources_)
      code = std::max(code, tell_damage(program_, source.messages));
    if (!options_.read_again) return code;
    if (code != 0 && copier_->statistics().messages == 0)
      return fail("nothing of it can be read that is a message");
    if (done = read_again(); !done) return fail(done.error().message);
    return code;
  }

 private:
  int fail(const std::string& sentence) const {
    std::cerr << program_ << ": " << sentence << '\n';
    return kFailed;
  }

  /// Errors: the file to write is one of the recordings, or one of these cannot be read.
  Result<void> open() {
    if (auto right = check_written_files({options_.output.path}, options_.files); !right)
      return right;
    for (const auto& file : options_.files) {
      auto recording = Recording::open(file);
      if (!recording) return recording.error();
      recordings_.push_back(std::make_unique<Recording>(std::move(recording).value()));
    }
    Selection selection = options_.selection;
    if (options_.with_states) selection.from_s = 0;  // because the states before are kept
    for (const auto& recording : recordings_) {
      auto messages = SelectedMessages::of(
          *recording, selection, std::max(kLeastBytes, kReadingBytes / recordings_.size()),
          sources_.empty() ? ShowsProgress::kYes : ShowsProgress::kNo);
      if (!messages) return messages.error();
      sources_.push_back({recording.get(), std::move(messages).value()});
    }
    for (auto& source : sources_) source.next = source.messages.next();
    return {};
  }

  [[nodiscard]] bool is_part() const { return !part_text(options_.selection).empty(); }

  /// Says what was asked for, of which no recording has a message.
  [[nodiscard]] std::string nothing_is_there() const {
    const auto& selection = options_.selection;
    const std::string text = sources_.size() == 1
                                 ? nothing_text(selection, sources_.front().messages)
                                 : "there is no message" + part_text(selection);
    return text + "; nothing was written";
  }

  Result<void> create() {
    auto copier = Copier::create(options_.output, recordings_.front()->summary().header);
    if (!copier) return copier.error();
    copier_ = std::move(copier).value();
    return {};
  }

  Result<void> copy() {
    const bool part = options_.selection.from_s > 0 || options_.selection.to_s;
    for (const auto& source : sources_)
      if (auto done = copier_->copy_extras(*source.recording, part); !done) return done;
    for (const auto& source : sources_)
      if (auto done = copy_channels(source); !done) return done;
    while (CopySource* source = earliest()) {
      if (auto done = take(*source); !done) return done;
      source->next = source->messages.next();
    }
    if (auto done = copy_kept(); !done) return done;
    for (const auto& source : sources_)
      if (auto done = tell_losses(source); !done) return done;
    return copier_->finish();
  }

  /// Has the copy tell what it lacks because its source is damaged, or lacked it already.
  Result<void> tell_losses(const CopySource& source) {
    const auto& recording = *source.recording;
    monitor::CopiedPart part{source.messages.log_times(options_.selection), {}};
    if (!source.messages.takes_all_topics())
      part.takes = [&](const std::string& topic) { return takes_topic(source, topic); };
    for (const auto& before : monitor::copy_losses(recording.summary()))
      if (auto done = copier_->tell_losses(monitor::part_of(before, part)); !done) return done;
    return copier_->tell_losses(monitor::losses_of_copying(recording.path(), recording.summary(),
                                                           source.messages.damages(), part));
  }

  static bool takes_topic(const CopySource& source, const std::string& topic) {
    return std::ranges::any_of(source.recording->summary().channels, [&](const auto& each) {
      return each.second.topic == topic && source.messages.takes_channel(each.first);
    });
  }

  /// Copies what a recording lists, with messages or without: that nothing came is a fact, too.
  Result<void> copy_channels(const CopySource& source) {
    if (source.messages.takes_all_topics()) copier_->copy_schemas(*source.recording);
    for (const auto& [id, channel] : source.recording->summary().channels) {
      if (!source.messages.takes_channel(id)) continue;
      if (auto done = copier_->copy_channel(*source.recording, id); !done) return done;
    }
    return {};
  }

  /// Returns the source of the earliest message; of one time, the first that was named.
  CopySource* earliest() {
    CopySource* first = nullptr;
    for (auto& source : sources_)
      if (source.next && (!first || source.next->log_ns < first->next->log_ns)) first = &source;
    return first;
  }

  Result<void> take(const CopySource& source) {
    const bool early = source.messages.at_s() < options_.selection.from_s;
    if (options_.with_states && early) {
      kept_.keep(*source.next, delivery_in(source.recording->summary(), source.next->channel_id));
      return {};
    }
    if (auto done = copy_kept(); !done) return done;
    return copier_->copy(*source.recording, *source.next);
  }

  /// States are kept of one recording only, since only slices begin with them.
  Result<void> copy_kept() {
    Result<void> done;
    kept_.give([&](const mcap::Message& message) {
      if (done) done = copier_->copy(*sources_.front().recording, message);
    });
    return done;
  }

  int tell_what_is_not_as_asked() const {
    for (const auto& sentence : copier_->unchanged_schemas())
      std::cerr << program_ << ": " << sentence << '\n';
    for (const auto& name : copier_->broken_attachments())
      std::cerr << program_ << ": the attachment '" << visible(name)
                << "' is damaged and was left out\n";
    const bool all = copier_->broken_attachments().empty() && copier_->unchanged_schemas().empty();
    return all ? 0 : kIncomplete;
  }

  /// Errors: what was written is not whole.
  Result<void> read_again() const {
    const auto written = Recording::open(options_.output.path, mcap::Depth::kAll);
    if (!written) return written.error();
    const auto& summary = written.value().summary();
    if (summary.recovered() || summary.statistics.messages != copier_->statistics().messages)
      return Error{options_.output.path + " is not what was written; look after the disk"};
    return {};
  }

  void tell() const {
    const auto& statistics = copier_->statistics();
    std::printf("%s: %s of %s%s, %.1f MB\n", options_.output.path.c_str(),
                plural(statistics.messages, "message").c_str(),
                plural(statistics.channels, "channel").c_str(),
                silent_text(statistics.channels - statistics.channel_messages.size()).c_str(),
                static_cast<double>(copier_->bytes()) * 1e-6);
    std::fflush(stdout);
    if (statistics.messages == 0)
      std::cerr << program_ << ": no message can be read, so that there is none in it\n";
  }

  std::string program_;
  const CopyOptions& options_;
  std::vector<std::unique_ptr<Recording>> recordings_;
  std::vector<CopySource> sources_;
  std::unique_ptr<Copier> copier_;
  monitor::LateJoiner kept_;
};

}  // namespace

int copy_recordings(const std::string& verb, const CopyOptions& options) {
  return Copying("galilean log " + verb, options).run();
}

}  // namespace galilean::logs
