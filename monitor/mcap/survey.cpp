// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/survey.h"

#include <algorithm>
#include <cstring>

#include "monitor/mcap/record_taker.h"
#include "monitor/mcap/resync.h"

namespace galilean::mcap {
namespace {

class Surveyor {
 public:
  Surveyor(const ByteSource& source, std::vector<ChunkIndex> known, std::uint64_t data_end)
      : window_(source),
        known_(std::move(known)),
        data_end_(data_end),
        taker_(window_, data_end, found_) {
    std::erase_if(known_, [&](const ChunkIndex& each) {
      const std::uint64_t end = window_.end();
      return each.length > end || each.message_index_length > end || each.offset > end ||
             each.offset + each.length + each.message_index_length > end;
    });
    std::ranges::sort(known_, {}, &ChunkIndex::offset);
  }

  Survey run() {
    while (!taker_.over() && at_ < window_.end()) step();
    found_.end = at_;
    return std::move(found_);
  }

 private:
  void step() {
    while (next_known_ < known_.size() && known_[next_known_].offset < at_) ++next_known_;
    if (is_known_here()) return take_known(known_[next_known_++]);
    const ByteView head = window_.at(at_, kRecordHead);
    if (head.size() < kRecordHead) return lose("the file ends within a record");
    RecordPlace record{.opcode = static_cast<Opcode>(head[0]), .offset = at_};
    std::memcpy(&record.length, head.data() + 1, sizeof record.length);
    if (const auto problem = implausible(record); !problem.empty()) return lose(problem);
    if (!taker_.take(record))
      return lose("the record at byte " + std::to_string(at_) + " contradicts itself");
    if (taker_.over()) return;
    last_ = at_;
    at_ += record.bytes();
  }

  [[nodiscard]] bool is_known_here() const {
    return next_known_ < known_.size() && known_[next_known_].offset == at_;
  }

  /// Returns the offset behind which no record that begins here can reach.
  [[nodiscard]] std::uint64_t limit() const {
    if (next_known_ < known_.size()) return known_[next_known_].offset;
    return data_end_ != 0 && at_ < data_end_ ? data_end_ : window_.end();
  }

  [[nodiscard]] std::string implausible(const RecordPlace& record) const {
    const std::string name = "the record at byte " + std::to_string(at_);
    if (record.opcode == Opcode{0}) return name + " is of no kind";
    if (record.length > window_.end() || at_ + record.bytes() > window_.end())
      return name + " is cut short by the end of the file";
    if (at_ + record.bytes() > limit()) return name + " reaches into what follows it";
    return {};
  }

  /// Takes a chunk as the summary lists it, so that its head need not be whole.
  void take_known(const ChunkIndex& index) {
    const auto head = chunk_head_at(window_, at_);
    const ByteView length = window_.at(at_ + 1, 8);
    std::uint64_t content = 0;
    if (length.size() == sizeof content) std::memcpy(&content, length.data(), sizeof content);
    if (!head || kRecordHead + content != index.length)
      found_.damages.push_back({.what = "the head of the chunk at byte " + std::to_string(at_) +
                                        " differs from what the summary says",
                                .offset = at_,
                                .messages = 0});
    ++found_.compressions[index.compression];
    found_.blocks.push_back({.offset = at_,
                             .bytes = index.length,
                             .start_ns = index.start_ns,
                             .end_ns = index.end_ns,
                             .uncompressed_bytes = index.uncompressed_size,
                             .index_offset = at_ + index.length,
                             .index_bytes = index.message_index_length});
    taker_.forget_chunk();
    last_ = at_;
    at_ += index.length + index.message_index_length;
  }

  /// Notes that no record can be read here, and goes on at the next chunk. A record before may have
  /// led here by a damaged length, so the search begins within it.
  void lose(const std::string& what) {
    Damage damage{.what = what, .offset = at_};
    const auto chunk = chunk_head_at(window_, at_);
    if (chunk) {
      damage.what = "the chunk at byte " + std::to_string(at_) + " is cut short";
      damage.time = TimeRange{chunk->start_ns, chunk->end_ns};
    }
    found_.damages.push_back(std::move(damage));
    taker_.forget_chunk();
    const bool after_chunk = !found_.blocks.empty() && found_.blocks.back().offset == last_;
    at_ = next_place(chunk || after_chunk ? at_ : last_);
  }

  std::uint64_t next_place(std::uint64_t behind) {
    if (next_known_ < known_.size()) return known_[next_known_].offset;
    searched_ = find_chunk(window_, std::max(behind, searched_) + 1).value_or(window_.end());
    return searched_;
  }

  ByteWindow window_;
  std::vector<ChunkIndex> known_;
  std::size_t next_known_ = 0;
  std::uint64_t data_end_;
  std::uint64_t at_ = sizeof kMagic, last_ = sizeof kMagic, searched_ = 0;
  Survey found_;
  RecordTaker taker_;
};

}  // namespace

Survey survey(const ByteSource& source, std::vector<ChunkIndex> known, std::uint64_t data_end) {
  return Surveyor(source, std::move(known), data_end).run();
}

}  // namespace galilean::mcap
