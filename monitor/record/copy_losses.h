// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "monitor/mcap/mcap_reader.h"

namespace galilean::monitor {

/// The metadata in which a copy tells what could not be taken from the file that it was made from.
/// A copy of several files has one for each that lacks something.
inline constexpr const char* kCopyLossesMetadata = "losses in copying";

/// What a copy lacks because the file that it was made from is damaged, or was not closed.
struct CopyLosses {
  std::string file;  ///< the name of the file that was copied, without its folder
  std::map<std::string, std::uint64_t> topics;  ///< how many messages of each are lost, as known
  std::uint64_t others = 0;                     ///< lost messages whose topic is not known
  bool is_exact = true;                         ///< whether no other message is lost
  std::vector<mcap::TimeRange> times;           ///< when messages are lost; none: at any time

  /// Returns how many messages are lost, as far as is known.
  [[nodiscard]] std::uint64_t missing() const noexcept;
  /// Returns whether anything is lost, or may be.
  [[nodiscard]] bool any() const noexcept { return missing() > 0 || !is_exact; }
  bool operator==(const CopyLosses&) const = default;
};

/// The part of a recording that is copied.
struct CopiedPart {
  std::optional<mcap::TimeRange> time;                  ///< nothing: all of its time
  std::function<bool(const std::string& topic)> takes;  ///< empty: all topics
};

/// Returns how many messages of each channel are lost by damage, as far as is known. `damages` are
/// all that were met.
[[nodiscard]] std::map<std::uint16_t, std::uint64_t> lost_by_channel(
    const mcap::Summary& summary, const std::vector<mcap::Damage>& damages);

/// Returns what a copy of the part lacks, since `damages` were met in reading the file.
[[nodiscard]] CopyLosses losses_of_copying(const std::string& file, const mcap::Summary& summary,
                                           const std::vector<mcap::Damage>& damages,
                                           const CopiedPart& part);
/// Returns what a copy of a part of a copy lacks of what that one lacked.
[[nodiscard]] CopyLosses part_of(CopyLosses losses, const CopiedPart& part);

[[nodiscard]] mcap::Metadata metadata_of(const CopyLosses& losses);
/// Returns what a recording tells in such metadata. What is not as metadata_of() made it counts as
/// an unknown number of lost messages.
[[nodiscard]] std::vector<CopyLosses> copy_losses(const mcap::Summary& summary);

/// Returns a sentence without a full stop: how many messages are lost, and why.
[[nodiscard]] std::string copy_loss_text(const CopyLosses& losses);

}  // namespace galilean::monitor
