// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/newest_messages.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace galilean::mcap {

/// One search. What is wanted is open as long as an older block may have some of it.
class NewestMessages::Search {
  /// A message's place in the order of all.
  using Key = std::tuple<std::uint64_t, std::uint32_t, std::uint32_t>;
  struct Kept {
    OwnedMessage message;
    std::uint32_t block, entry;
    [[nodiscard]] Key key() const { return {message.head.log_ns, block, entry}; }
  };
  struct Open {
    Wanted wanted;
    std::vector<Kept> kept;  ///< the newest first
  };

 public:
  Search(std::uint64_t before_ns, const std::vector<Wanted>& wanted) : before_ns_(before_ns) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (wanted[i].most == 0) continue;
      open_[i].wanted = wanted[i];
      for (const auto channel : wanted[i].channels) place_of_[channel] = i;
    }
  }

  /// Closes that of which nothing can be at or before `end_ns`.
  void close_behind(std::uint64_t end_ns) {
    for (auto each = open_.begin(); each != open_.end();) {
      const auto& [what, kept] = each->second;
      const bool is_full = kept.size() == what.most && kept.back().message.head.log_ns > end_ns;
      if (!is_full && what.since_ns <= end_ns) {
        ++each;
        continue;
      }
      std::ranges::move(each->second.kept, std::back_inserter(done_));
      each = open_.erase(each);
    }
  }
  [[nodiscard]] bool is_over() const noexcept { return open_.empty(); }
  [[nodiscard]] bool wants_any(const BlockChannels::Counts& channels) const {
    return std::ranges::any_of(channels,
                               [&](const auto& each) { return find(each.channel_id) != nullptr; });
  }

  void take(std::uint32_t block, const LoadedBlock& content) {
    const auto end =
        std::ranges::lower_bound(content.entries, before_ns_, {}, &LoadedBlock::Entry::log_ns);
    for (auto at = end; at != content.entries.begin();)
      offer(block, static_cast<std::uint32_t>(--at - content.entries.begin()), content);
  }

  [[nodiscard]] std::vector<OwnedMessage> result() {
    close_behind(0);
    for (auto& [place, open] : open_) std::ranges::move(open.kept, std::back_inserter(done_));
    open_.clear();
    std::ranges::sort(done_, {}, [](const Kept& kept) { return kept.key(); });
    std::vector<OwnedMessage> messages;
    messages.reserve(done_.size());
    for (auto& kept : done_) messages.push_back(std::move(kept.message));
    return messages;
  }

 private:
  [[nodiscard]] const Open* find(std::uint16_t channel) const {
    const auto place = place_of_.find(channel);
    if (place == place_of_.end()) return nullptr;
    const auto open = open_.find(place->second);
    return open == open_.end() ? nullptr : &open->second;
  }

  void offer(std::uint32_t block, std::uint32_t entry, const LoadedBlock& content) {
    const auto& offered = content.entries[entry];
    const auto* open = find(offered.channel_id);
    if (!open || offered.log_ns < open->wanted.since_ns) return;
    auto& kept = open_.at(place_of_.at(offered.channel_id)).kept;
    const Key key(offered.log_ns, block, entry);
    const bool is_full = kept.size() == open->wanted.most;
    if (is_full && key < kept.back().key()) return;
    if (is_full) kept.pop_back();
    const auto place =
        std::ranges::find_if(kept, [&](const Kept& each) { return each.key() < key; });
    kept.insert(place, {OwnedMessage::of(content.message(offered)), block, entry});
  }

  std::uint64_t before_ns_;
  std::map<std::size_t, Open> open_;                         ///< by its place in what is wanted
  std::unordered_map<std::uint16_t, std::size_t> place_of_;  ///< by channel
  std::vector<Kept> done_;
};

NewestMessages::NewestMessages(const ByteSource& source, const std::vector<Block>& blocks,
                               BlockChannels& channels)
    : blocks_(blocks), channels_(channels), loader_(source), order_(blocks.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  std::ranges::stable_sort(order_, std::greater{},
                           [&](std::uint32_t block) { return blocks[block].end_ns; });
}

NewestMessages::Found NewestMessages::before(std::uint64_t before_ns,
                                             const std::vector<Wanted>& wanted) {
  Search search(before_ns, wanted);
  Found found;
  for (const auto block : order_) {
    if (blocks_[block].start_ns >= before_ns) continue;
    search.close_behind(blocks_[block].end_ns);
    if (search.is_over()) break;
    const auto* known = channels_.of(block);
    if (known && !search.wants_any(*known)) continue;
    loader_.load(blocks_[block], loaded_);
    if (!known) channels_.learn(block, loaded_);
    if (loaded_.damage) found.damages.push_back(*loaded_.damage);
    search.take(block, loaded_);
  }
  found.messages = search.result();
  return found;
}

}  // namespace galilean::mcap
