// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/shared_frame_ring.h"

#include <array>
#include <atomic>
#include <cstring>
#include <utility>

namespace galilean::robot {
namespace {

using Word = std::uint64_t;
constexpr std::size_t kWords = Frame::kBytes / sizeof(Word);
constexpr std::size_t kSlots = 4;
constexpr Word kMagic = 0x474c4e4652414d45;  // "GLNFRAME"
constexpr Duration kSilence = std::chrono::milliseconds(500);
constexpr Duration kSearchPause = std::chrono::seconds(1);
static_assert(kWords * sizeof(Word) == Frame::kBytes);
static_assert(std::atomic<Word>::is_always_lock_free);

}  // namespace

struct FrameRingLayout {
  struct Slot {
    std::atomic<Word> sequence;  // odd while the slot is written
    std::atomic<Word> number;
    std::array<std::atomic<Word>, kWords> rgb;
  };
  std::atomic<Word> magic;
  std::atomic<Word> generation;  // counts the writers
  std::atomic<Word> newest;      // number of the newest whole picture; 0: none
  std::array<Slot, kSlots> slots;
};

namespace {

using Slot = FrameRingLayout::Slot;

FrameRingLayout& layout(const SharedMemory& memory) {
  return *reinterpret_cast<FrameRingLayout*>(memory.bytes().data());
}

/// Each word is stored with release order, so that a reader that saw one of them also sees the odd
/// sequence.
void fill(Slot& slot, Word number, std::span<const std::uint8_t, Frame::kBytes> rgb) {
  const Word odd = (slot.sequence.load(std::memory_order_relaxed) + 1) | 1;
  slot.sequence.store(odd, std::memory_order_relaxed);
  slot.number.store(number, std::memory_order_release);
  for (std::size_t i = 0; i < kWords; ++i) {
    Word word;
    std::memcpy(&word, &rgb[i * sizeof word], sizeof word);
    slot.rgb[i].store(word, std::memory_order_release);
  }
  slot.sequence.store(odd + 1, std::memory_order_release);
}

/// Returns false if the writer changed the slot meanwhile. The copy is then useless.
bool copy_whole(const Slot& slot, Word number, Frame& frame) {
  const Word before = slot.sequence.load(std::memory_order_acquire);
  if (before & 1) return false;
  const bool expected = slot.number.load(std::memory_order_acquire) == number;
  for (std::size_t i = 0; i < kWords; ++i) {
    const Word word = slot.rgb[i].load(std::memory_order_acquire);
    std::memcpy(&frame.rgb[i * sizeof word], &word, sizeof word);
  }
  return expected && slot.sequence.load(std::memory_order_relaxed) == before;
}

}  // namespace

Result<std::unique_ptr<FrameRingWriter>> FrameRingWriter::create(const std::string& name) {
  auto memory = SharedMemory::own(name, sizeof(FrameRingLayout));
  if (!memory) return memory.error();
  return std::unique_ptr<FrameRingWriter>(new FrameRingWriter(name, std::move(memory).value()));
}

FrameRingWriter::FrameRingWriter(std::string name, SharedMemory memory)
    : name_(std::move(name)), memory_(std::move(memory)) {
  ring().newest = 0;
  ++ring().generation;
  ring().magic = kMagic;
}

FrameRingWriter::~FrameRingWriter() {
  SharedMemory::remove(name_);
}

FrameRingLayout& FrameRingWriter::ring() {
  return layout(memory_);
}

void FrameRingWriter::write(std::span<const std::uint8_t, Frame::kBytes> rgb) {
  const Word number = ring().newest.load(std::memory_order_relaxed) + 1;
  fill(ring().slots[number % kSlots], number, rgb);
  ring().newest.store(number, std::memory_order_release);
}

FrameRingReader::FrameRingReader(std::string name)
    : name_(std::move(name)), problem_("No picture has come from " + name_ + " yet.") {}

bool FrameRingReader::grab(Frame& frame, Time now) {
  if (memory_ && copy_newest(frame)) {
    last_picture_ = now;
    problem_.clear();
    return true;
  }
  if (!memory_ || now - last_picture_ > kSilence) look_for_ring(now);
  return false;
}

void FrameRingReader::look_for_ring(Time now) {
  if (looked_ && now - last_look_ < kSearchPause) return;
  looked_ = true;
  last_look_ = now;
  if (memory_ && memory_->is_current(name_)) {
    problem_ = "No pictures come through " + name_ + ": the simulator stands still or was killed.";
    return;
  }
  memory_.reset();
  auto memory = SharedMemory::join(name_, sizeof(FrameRingLayout));
  if (!memory) {
    problem_ =
        "The simulator's camera is missing: " + memory.error().message + " Start galilean sim.";
    return;
  }
  memory_ = std::move(memory).value();
  last_picture_ = now;
  generation_ = number_ = 0;
}

bool FrameRingReader::copy_newest(Frame& frame) {
  const FrameRingLayout& ring = layout(*memory_);
  if (ring.magic.load(std::memory_order_acquire) != kMagic) return false;
  constexpr int attempts = 3;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const Word generation = ring.generation.load(std::memory_order_acquire);
    const Word newest = ring.newest.load(std::memory_order_acquire);
    if (newest == 0 || (newest == number_ && generation == generation_)) return false;
    if (!copy_whole(ring.slots[newest % kSlots], newest, frame)) continue;
    number_ = newest;
    generation_ = generation;
    return true;
  }
  return false;
}

std::string FrameRingReader::problem() const {
  return problem_;
}

}  // namespace galilean::robot
