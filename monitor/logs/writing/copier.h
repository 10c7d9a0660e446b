// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "monitor/logs/reading/recording.h"
#include "monitor/mcap/mcap_writer.h"
#include "monitor/record/copy_losses.h"

namespace galilean::logs {

/// How a new recording is written.
struct OutputOptions {
  std::string path;
  bool replace = false;              ///< overwrite what is there
  std::string compression = "zstd";  ///< "zstd", "lz4" or "none"
  std::uint64_t chunk_kB = 1024;     ///< size of a chunk before it is compressed
  std::string schema;                ///< see in_language; empty: schemas stay as they are
};

/// Writes messages of recordings to a new one. Channels that are equal in all but their ids become
/// one, and so do schemas. Nothing of a message is changed but the id of its channel.
class Copier {
 public:
  /// Makes the file and begins it, with the profile of `first`. Requires: no recording that is
  /// copied from is the file. Errors: it exists, or it cannot be written.
  [[nodiscard]] static Result<std::unique_ptr<Copier>> create(const OutputOptions& options,
                                                              const mcap::Header& first);

  /// Copies the metadata and the attachments of a recording, each once if several have it. Of a
  /// part of the recording's time, it leaves out what was counted as missing of all of it. What a
  /// copy tells of its own losses is left to tell_losses(). It leaves out attachments that are not
  /// whole, too.
  Result<void> copy_extras(const Recording& from, bool part);
  /// Copies all schemas, also those that no channel has.
  void copy_schemas(const Recording& from);
  /// Copies a channel and its schema, though it may have no message.
  Result<void> copy_channel(const Recording& from, std::uint16_t id);
  /// Copies a message of a recording.
  Result<void> copy(const Recording& from, const mcap::Message& message);
  /// Writes what the copy lacks of a recording, once if several tell the same.
  Result<void> tell_losses(const monitor::CopyLosses& losses);
  /// Closes the file, and waits until it is on the disk.
  Result<void> finish();
  [[nodiscard]] const mcap::Statistics& statistics() const noexcept { return writer_.statistics(); }
  /// Returns sentences on schemas that could not be changed as was asked, without full stops.
  [[nodiscard]] const std::vector<std::string>& unchanged_schemas() const noexcept {
    return unchanged_schemas_;
  }
  /// Returns the names of the attachments that were left out.
  [[nodiscard]] const std::vector<std::string>& broken_attachments() const noexcept {
    return broken_attachments_;
  }
  [[nodiscard]] std::uint64_t bytes() const noexcept { return writer_.bytes_written(); }

 private:
  using ChannelKey = std::tuple<std::uint16_t, std::string, std::string, mcap::Text>;

  Copier(mcap::FileSink file, mcap::WriterOptions options, std::string schema)
      : file_(std::move(file)), writer_(file_, std::move(options)), language_(std::move(schema)) {}
  [[nodiscard]] mcap::Schema changed(const mcap::Schema& schema);
  Result<std::uint16_t> channel_for(const Recording& from, std::uint16_t id);
  std::uint16_t schema_for(const Recording& from, std::uint16_t id);

  mcap::FileSink file_;
  mcap::Writer writer_;
  std::string language_;
  std::map<std::pair<const Recording*, std::uint16_t>, std::uint16_t> known_;  ///< new ids
  std::map<ChannelKey, std::uint16_t> channels_;
  std::map<std::tuple<std::string, std::string, std::string>, std::uint16_t> schemas_;
  std::set<std::pair<std::string, mcap::Text>> metadata_;
  std::set<std::tuple<std::string, std::uint64_t, std::uint64_t>> attachments_;
  std::vector<std::string> broken_attachments_, unchanged_schemas_;
};

}  // namespace galilean::logs
