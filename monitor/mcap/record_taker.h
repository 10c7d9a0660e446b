// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/mcap/byte_window.h"
#include "monitor/mcap/survey.h"

namespace galilean::mcap {

/// Where a record stands.
struct RecordPlace {
  Opcode opcode{};
  std::uint64_t offset = 0;  ///< of its head
  std::uint64_t length = 0;  ///< of its content [bytes]
  [[nodiscard]] std::uint64_t bytes() const noexcept { return kRecordHead + length; }
};

/// Adds records of the data section to a Survey, without the contents of chunks and attachments.
class RecordTaker {
 public:
  /// @param data_end  offset at which the data section must end; 0 if it is not known
  RecordTaker(ByteWindow& window, std::uint64_t data_end, Survey& to)
      : window_(window), data_end_(data_end), found_(to) {}

  /// Returns false if the record contradicts itself. Requires: it lies within the file.
  bool take(const RecordPlace& record);
  /// Returns whether the end of the data section was taken.
  [[nodiscard]] bool over() const noexcept { return over_; }
  /// Lets message indexes that come now belong to no chunk.
  void forget_chunk() noexcept { indexed_ = false; }

 private:
  ByteView content_of(const RecordPlace& record, std::size_t size);
  template <class Content>
  bool take_content(const RecordPlace& record, Content& content);
  template <class Content>
  bool take_numbered(const RecordPlace& record, std::map<std::uint16_t, Content>& all);
  bool take_metadata(const RecordPlace& record);
  bool take_message(const RecordPlace& record);
  bool take_chunk(const RecordPlace& record);
  bool take_message_index(const RecordPlace& record);
  bool take_attachment(const RecordPlace& record);
  bool take_end(const RecordPlace& record);

  ByteWindow& window_;
  std::uint64_t data_end_;
  Survey& found_;
  bool indexed_ = false;  ///< whether a message index here belongs to the last block
  bool over_ = false;
};

}  // namespace galilean::mcap
