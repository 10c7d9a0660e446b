// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "core/static_vector.h"
#include "core/variable/variable.h"
#include "robot/vision/threshold.h"

namespace galilean::robot {

/// A connected set of pixels. Bounds are inclusive; rows count from the top.
struct Blob {
  std::uint32_t area_px = 0;
  int left_px = 0, top_px = 0, right_px = 0, bottom_px = 0;
  double centroid_column_px = 0;  ///< mean of the pixels' columns: 0.0 is the middle of column 0
  double centroid_row_px = 0;
  double lowest_column_px = 0;  ///< middle of the blob's pixels in its bottom row
};

/// Finds blobs in an 8-bit image: threshold to a bit mask, mask to runs, union of the runs that
/// touch (8 neighbours), statistics on the way. Rows are scanned from the bottom up: the nearest
/// objects come first, and what does not fit into the fixed capacity is what is far.
///   source  run-length components after CMVision (Bruce, Balch, Veloso 2000); union-find with path
///           halving (Tarjan and van Leeuwen 1984)
class BlobFinder {
 public:
  static constexpr std::size_t kMaxRegions = 4096;
  static constexpr std::size_t kMaxBlobs = 64;
  using Blobs = StaticVector<Blob, kMaxBlobs>;

  /// Returns the blobs of at least `min_area_px`, the lowest bottom row first. They are valid until
  /// the next call. Requires: `pixels` is one Image::kWidth × Image::kHeight picture. It never
  /// allocates.
  const Blobs& find(std::span<const std::uint8_t> pixels, Threshold threshold,
                    std::uint32_t min_area_px) noexcept;

  /// Returns whether the last picture had more regions or blobs than there is room for.
  [[nodiscard]] bool overflowed() const noexcept { return overflowed_; }

 private:
  using Index = std::uint16_t;
  static constexpr Index kNone = 0xFFFF;

  struct Run {
    std::uint16_t left, right;
    Index region;
  };
  struct Region {
    Index parent;
    std::uint16_t left, right, top, bottom;
    std::uint16_t lowest_left, lowest_right;
    std::uint32_t area, column_sum, row_sum;
  };
  struct Row {
    std::array<Run, Image::kWidth / 2 + 1> runs;
    std::size_t count;
  };

  void extract_runs(int y, Row& row) const noexcept;
  void link(Row& row, const Row& below, int y) noexcept;
  [[nodiscard]] Index touching_region(const Run& run, const Row& below,
                                      std::size_t& first) noexcept;
  [[nodiscard]] Index create(const Run& run, int y) noexcept;
  void absorb(Region& region, const Run& run, int y) noexcept;
  [[nodiscard]] Index root(Index region) noexcept;
  [[nodiscard]] Index unite(Index a, Index b) noexcept;
  void collect(std::uint32_t min_area_px) noexcept;

  std::array<std::uint8_t, mask_bytes(Image::kWidth* Image::kHeight)> mask_{};
  std::array<Row, 2> rows_{};
  // The array is not set to zero: a swap waits for its allocation, and only counted regions are
  // read.
  std::unique_ptr<Region[]> regions_ = std::make_unique_for_overwrite<Region[]>(kMaxRegions);
  std::size_t region_count_ = 0;
  Blobs blobs_;
  bool overflowed_ = false;
};

}  // namespace galilean::robot
