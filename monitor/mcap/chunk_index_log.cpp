// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/chunk_index_log.h"

namespace galilean::mcap {
namespace {

constexpr std::size_t kPageBytes = std::size_t{1} << 16;
constexpr std::size_t kIndexBytes = std::size_t{1} << 13;  ///< more than most indexes take
/// Seven bits of a number stand in each byte; the eighth says that more follow.
constexpr unsigned kBits = 7;
constexpr std::uint8_t kMore = 1U << kBits;

/// Returns the offset behind a chunk and its message indexes.
std::uint64_t end_of(const ChunkIndex& index) {
  return index.offset + index.length + index.message_index_length;
}

/// Numbers go back, too: a difference is kept so that small ones of both signs are small.
std::uint64_t folded(std::uint64_t difference) {
  return difference << 1U ^ (difference >> 63U != 0 ? ~std::uint64_t{0} : 0);
}
std::uint64_t unfolded(std::uint64_t number) {
  return number >> 1U ^ ((number & 1U) != 0 ? ~std::uint64_t{0} : 0);
}

}  // namespace

void ChunkIndexLog::put(std::uint64_t number) {
  auto& page = pages_.back();
  for (; number >= kMore; number >>= kBits)
    page.push_back(static_cast<std::uint8_t>(number) | kMore);
  page.push_back(static_cast<std::uint8_t>(number));
}

void ChunkIndexLog::add(const ChunkIndex& index) {
  if (pages_.empty() || pages_.back().size() >= kPageBytes)
    pages_.emplace_back().reserve(kPageBytes + kIndexBytes);
  put(folded(index.start_ns - start_ns_));
  put(folded(index.end_ns - index.start_ns));
  put(folded(index.offset - end_));
  put(index.length);
  put(index.message_index_length);
  put(index.compressed_size);
  put(index.uncompressed_size);
  put(index.message_index_offsets.size());
  std::uint64_t channel = 0, offset = index.offset + index.length;
  for (const auto& [id, at] : index.message_index_offsets) {
    put(id - channel);
    put(folded(at - offset));
    channel = id;
    offset = at;
  }
  start_ns_ = index.start_ns;
  end_ = end_of(index);
}

std::size_t ChunkIndexLog::bytes() const noexcept {
  std::size_t all = 0;
  for (const auto& page : pages_) all += page.capacity();
  return all;
}

std::uint64_t ChunkIndexLog::Reader::take() {
  const auto& page = log_.pages_[page_];
  std::uint64_t number = 0;
  for (unsigned shift = 0;; shift += kBits) {
    const std::uint8_t byte = page[at_++];
    number |= std::uint64_t{byte & (kMore - 1U)} << shift;
    if ((byte & kMore) == 0) return number;
  }
}

const ChunkIndex* ChunkIndexLog::Reader::next() {
  if (page_ < log_.pages_.size() && at_ == log_.pages_[page_].size()) {
    ++page_;
    at_ = 0;
  }
  if (page_ == log_.pages_.size()) return nullptr;
  const std::uint64_t before_end = end_of(index_);
  index_.start_ns += unfolded(take());
  index_.end_ns = index_.start_ns + unfolded(take());
  index_.offset = before_end + unfolded(take());
  index_.length = take();
  index_.message_index_length = take();
  index_.compressed_size = take();
  index_.uncompressed_size = take();
  index_.message_index_offsets.clear();
  std::uint64_t channel = 0, offset = index_.offset + index_.length;
  for (std::uint64_t left = take(); left > 0; --left) {
    channel += take();
    offset += unfolded(take());
    index_.message_index_offsets.emplace_hint(index_.message_index_offsets.end(),
                                              static_cast<std::uint16_t>(channel), offset);
  }
  return &index_;
}

}  // namespace galilean::mcap
