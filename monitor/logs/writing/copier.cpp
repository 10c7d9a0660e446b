// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/writing/copier.h"

#include <limits>
#include <utility>

#include "core/visible_text.h"
#include "monitor/logs/reading/attachments.h"
#include "monitor/logs/writing/schema_language.h"
#include "monitor/record/damage_text.h"
#include "monitor/record/losses.h"

namespace galilean::logs {
namespace {

mcap::Compression compression_of(const std::string& word) {
  if (word == "none") return mcap::Compression::kNone;
  return word == "lz4" ? mcap::Compression::kLz4 : mcap::Compression::kFast;
}

mcap::WriterOptions writer_options(const OutputOptions& options, const mcap::Header& first) {
  return {.profile = first.profile,
          .library = "galilean " GALILEAN_VERSION,
          .chunk_bytes = static_cast<std::size_t>(options.chunk_kB) * 1024,
          .compression = compression_of(options.compression)};
}

bool is_of_the_whole(const mcap::Metadata& metadata) {
  return metadata.name == monitor::kLossesMetadata ||
         metadata.name == monitor::kLossesBeforeMetadata;
}

}  // namespace

Result<std::unique_ptr<Copier>> Copier::create(const OutputOptions& options,
                                               const mcap::Header& first) {
  auto file = mcap::FileSink::create(options.path, options.replace);
  if (!file) return file.error();
  std::unique_ptr<Copier> copier(
      new Copier(std::move(file).value(), writer_options(options, first), options.schema));
  if (auto done = copier->writer_.begin(); !done) return done.error();
  return Result<std::unique_ptr<Copier>>(std::move(copier));
}

Result<void> Copier::copy_extras(const Recording& from, bool part) {
  for (const auto& metadata : from.summary().metadata) {
    if (part && is_of_the_whole(metadata)) continue;
    if (metadata.name == monitor::kCopyLossesMetadata) continue;
    if (!metadata_.emplace(metadata.name, metadata.entries).second) continue;
    if (auto done = writer_.write(metadata); !done) return done;
  }
  for (const auto& attachment : from.summary().attachments) {
    const std::tuple key(attachment.name, attachment.log_ns, attachment.data_bytes);
    if (!attachments_.insert(key).second) continue;
    if (!is_whole(from.source(), attachment)) {
      broken_attachments_.push_back(attachment.name);
      continue;
    }
    if (auto done = writer_.write(attachment, from.source()); !done) return done;
  }
  return {};
}

Result<void> Copier::tell_losses(const monitor::CopyLosses& losses) {
  if (!losses.any()) return {};
  const auto metadata = monitor::metadata_of(losses);
  if (!metadata_.emplace(metadata.name, metadata.entries).second) return {};
  return writer_.write(metadata);
}

std::uint16_t Copier::schema_for(const Recording& from, std::uint16_t id) {
  const auto found = from.summary().schemas.find(id);
  if (found == from.summary().schemas.end()) return 0;  // MCAP's id for no schema
  const auto& schema = found->second;
  auto& made = schemas_[{schema.name, schema.encoding, schema.data}];
  if (made != 0) return made;
  const auto written = changed(schema);
  return made = writer_.add_schema(written.name, written.encoding, written.data);
}

/// Returns the schema in the language that was asked for, or as it is if that cannot be.
mcap::Schema Copier::changed(const mcap::Schema& schema) {
  if (language_.empty()) return schema;
  auto other = in_language(schema, language_);
  if (other) return std::move(other).value();
  unchanged_schemas_.push_back("the type " + visible(schema.name) + ", " + other.error().message +
                               ": its schema stays as it is");
  return schema;
}

Result<std::uint16_t> Copier::channel_for(const Recording& from, std::uint16_t id) {
  auto& known = known_[{&from, id}];
  if (known != 0) return known;
  const auto found = from.summary().channels.find(id);
  mcap::Channel channel;
  if (found != from.summary().channels.end())
    channel = found->second;
  else
    channel.topic = monitor::topic_of(id, from.summary());
  channel.schema_id = schema_for(from, channel.schema_id);
  auto& made =
      channels_[{channel.schema_id, channel.topic, channel.message_encoding, channel.metadata}];
  if (made == 0) {
    if (channels_.size() >= std::numeric_limits<std::uint16_t>::max())
      return Error{"there are more channels than a recording can have"};
    made = writer_.add_channel(std::move(channel));
  }
  return known = made;
}

void Copier::copy_schemas(const Recording& from) {
  for (const auto& [id, schema] : from.summary().schemas) (void)schema_for(from, id);
}

Result<void> Copier::copy_channel(const Recording& from, std::uint16_t id) {
  if (const auto made = channel_for(from, id); !made) return made.error();
  return {};
}

Result<void> Copier::copy(const Recording& from, const mcap::Message& message) {
  const auto channel = channel_for(from, message.channel_id);
  if (!channel) return channel.error();
  mcap::Message copied = message;
  copied.channel_id = channel.value();
  return writer_.write(copied);
}

Result<void> Copier::finish() {
  if (auto done = writer_.end(); !done) return done;
  return file_.sync();
}

}  // namespace galilean::logs
