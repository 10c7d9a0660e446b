// SPDX-License-Identifier: BSD-3-Clause
#include "robot/vision/blobs.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace galilean::robot {
namespace {

constexpr int kWordBits = 32;
constexpr int kRowWords = Image::kWidth / kWordBits;
static_assert(Image::kWidth % kWordBits == 0, "a row of the mask is a whole number of words");
static_assert(std::endian::native == std::endian::little,
              "four bytes of the mask are read as one word, whose lowest bit must be the first "
              "pixel of the first byte");

}  // namespace

const BlobFinder::Blobs& BlobFinder::find(std::span<const std::uint8_t> pixels, Threshold threshold,
                                          std::uint32_t min_area_px) noexcept {
  threshold_mask(pixels, threshold, mask_.data());
  region_count_ = 0;
  overflowed_ = false;
  rows_[0].count = rows_[1].count = 0;
  for (int y = Image::kHeight - 1; y >= 0; --y) {
    Row& row = rows_[static_cast<std::size_t>(y & 1)];
    extract_runs(y, row);
    link(row, rows_[static_cast<std::size_t>(~y & 1)], y);
  }
  collect(min_area_px);
  return blobs_;
}

/// Finds the runs of a row. Every set bit of `changes` is a pixel that differs from its left
/// neighbour.
void BlobFinder::extract_runs(int y, Row& row) const noexcept {
  row.count = 0;
  const std::uint8_t* bytes = mask_.data() + y * (Image::kWidth / 8);
  std::uint32_t last = 0;
  for (int word = 0; word < kRowWords; ++word) {
    std::uint32_t bits;
    std::memcpy(&bits, bytes + word * 4, sizeof bits);
    for (std::uint32_t changes = bits ^ (bits << 1 | last); changes; changes &= changes - 1) {
      const auto column = static_cast<std::uint16_t>(word * kWordBits + std::countr_zero(changes));
      if (bits >> (column % kWordBits) & 1U)
        row.runs[row.count] = {column, Image::kWidth - 1, kNone};
      else
        row.runs[row.count++].right = static_cast<std::uint16_t>(column - 1);
    }
    last = bits >> (kWordBits - 1);
  }
  row.count += last;
}

void BlobFinder::link(Row& row, const Row& below, int y) noexcept {
  std::size_t first = 0;
  for (std::size_t i = 0; i < row.count; ++i) {
    Run& run = row.runs[i];
    run.region = touching_region(run, below, first);
    if (run.region == kNone)
      run.region = create(run, y);
    else
      absorb(regions_[run.region], run, y);
  }
}

/// Returns the region below that the run touches, or kNone. `first` is the first run below that may
/// touch this run or one further right.
BlobFinder::Index BlobFinder::touching_region(const Run& run, const Row& below,
                                              std::size_t& first) noexcept {
  while (first < below.count && below.runs[first].right + 1 < run.left) ++first;
  Index found = kNone;
  for (std::size_t i = first; i < below.count && below.runs[i].left <= run.right + 1; ++i) {
    const Index region = below.runs[i].region;
    if (region != kNone) found = found == kNone ? root(region) : unite(found, region);
  }
  return found;
}

BlobFinder::Index BlobFinder::create(const Run& run, int y) noexcept {
  if (region_count_ == kMaxRegions) {
    overflowed_ = true;
    return kNone;
  }
  const auto index = static_cast<Index>(region_count_++);
  const auto row = static_cast<std::uint16_t>(y);
  regions_[index] = {index, run.left, run.right, row, row, run.left, run.right, 0, 0, 0};
  absorb(regions_[index], run, y);
  return index;
}

void BlobFinder::absorb(Region& region, const Run& run, int y) noexcept {
  const std::uint32_t length = run.right - run.left + 1U;
  region.area += length;
  region.column_sum += length * (run.left + run.right) / 2;
  region.row_sum += length * static_cast<std::uint32_t>(y);
  region.left = std::min(region.left, run.left);
  region.right = std::max(region.right, run.right);
  region.top = static_cast<std::uint16_t>(y);
}

BlobFinder::Index BlobFinder::root(Index region) noexcept {
  while (regions_[region].parent != region) {
    regions_[region].parent = regions_[regions_[region].parent].parent;
    region = regions_[region].parent;
  }
  return region;
}

/// Unites two regions. The older one becomes the root, because its bottom row is at least as low.
BlobFinder::Index BlobFinder::unite(Index a, Index b) noexcept {
  a = root(a);
  b = root(b);
  if (a == b) return a;
  Region& kept = regions_[std::min(a, b)];
  Region& gone = regions_[std::max(a, b)];
  gone.parent = kept.parent;
  if (gone.bottom == kept.bottom) {
    kept.lowest_left = std::min(kept.lowest_left, gone.lowest_left);
    kept.lowest_right = std::max(kept.lowest_right, gone.lowest_right);
  }
  kept.area += gone.area;
  kept.column_sum += gone.column_sum;
  kept.row_sum += gone.row_sum;
  kept.left = std::min(kept.left, gone.left);
  kept.right = std::max(kept.right, gone.right);
  kept.top = std::min(kept.top, gone.top);
  return kept.parent;
}

void BlobFinder::collect(std::uint32_t min_area_px) noexcept {
  blobs_.clear();
  for (std::size_t i = 0; i < region_count_; ++i) {
    const Region& region = regions_[i];
    if (region.parent != i || region.area < min_area_px) continue;
    const Blob blob{.area_px = region.area,
                    .left_px = region.left,
                    .top_px = region.top,
                    .right_px = region.right,
                    .bottom_px = region.bottom,
                    .centroid_column_px = double(region.column_sum) / region.area,
                    .centroid_row_px = double(region.row_sum) / region.area,
                    .lowest_column_px = (region.lowest_left + region.lowest_right) / 2.0};
    if (!blobs_.push_back(blob)) {
      overflowed_ = true;
      return;
    }
  }
}

}  // namespace galilean::robot
