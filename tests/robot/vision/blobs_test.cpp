// SPDX-License-Identifier: BSD-3-Clause
#include "robot/vision/blobs.h"

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <algorithm>
#include <memory>
#include <tuple>
#include <vector>

#include "core/random.h"

namespace galilean::robot {
namespace {

constexpr int kWidth = Image::kWidth;
constexpr int kHeight = Image::kHeight;
using Picture = std::vector<std::uint8_t>;

std::uint8_t& at(Picture& picture, int x, int y) {
  return picture[static_cast<std::size_t>(y * kWidth + x)];
}

void fill(Picture& picture, int left, int top, int right, int bottom, std::uint8_t level) {
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) at(picture, x, y) = level;
}

/// The definition: flood fill over the eight neighbours.
Blob flood(Picture& picture, int x, int y, int level) {
  Blob blob{.left_px = x, .top_px = y, .right_px = x, .bottom_px = y};
  std::vector<std::pair<int, int>> open{{x, y}};
  at(picture, x, y) = 0;
  int low_left = x, low_right = x;
  double columns = 0, rows = 0;
  while (!open.empty()) {
    const auto [cx, cy] = open.back();
    open.pop_back();
    ++blob.area_px;
    columns += cx;
    rows += cy;
    if (cy > blob.bottom_px) low_left = low_right = cx;
    if (cy >= blob.bottom_px) {
      low_left = std::min(low_left, cx);
      low_right = std::max(low_right, cx);
    }
    blob.left_px = std::min(blob.left_px, cx);
    blob.right_px = std::max(blob.right_px, cx);
    blob.top_px = std::min(blob.top_px, cy);
    blob.bottom_px = std::max(blob.bottom_px, cy);
    for (int ny = std::max(0, cy - 1); ny <= std::min(kHeight - 1, cy + 1); ++ny)
      for (int nx = std::max(0, cx - 1); nx <= std::min(kWidth - 1, cx + 1); ++nx)
        if (at(picture, nx, ny) >= level) {
          at(picture, nx, ny) = 0;
          open.emplace_back(nx, ny);
        }
  }
  blob.centroid_column_px = columns / blob.area_px;
  blob.centroid_row_px = rows / blob.area_px;
  blob.lowest_column_px = (low_left + low_right) / 2.0;
  return blob;
}

auto key(const Blob& blob) {
  return std::tuple(blob.bottom_px, blob.left_px, blob.top_px, blob.right_px, blob.area_px,
                    blob.lowest_column_px);
}

std::vector<Blob> sorted(std::vector<Blob> blobs) {
  std::ranges::sort(blobs, {}, key);
  return blobs;
}

std::vector<Blob> by_definition(Picture picture, int level, std::uint32_t min_area) {
  std::vector<Blob> blobs;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (at(picture, x, y) >= level) blobs.push_back(flood(picture, x, y, level));
  std::erase_if(blobs, [&](const Blob& blob) { return blob.area_px < min_area; });
  return sorted(std::move(blobs));
}

class BlobsTest : public ::testing::Test {
 protected:
  std::vector<Blob> find(const Picture& picture, Threshold threshold, std::uint32_t min_area) {
    const auto& found = finder_->find(picture, threshold, min_area);
    return {found.begin(), found.end()};
  }
  std::unique_ptr<BlobFinder> finder_ = std::make_unique<BlobFinder>();
  Picture picture_ = Picture(kWidth * kHeight);
};

TEST_F(BlobsTest, EqualsFloodFillOnRandomPictures) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const auto density = static_cast<std::uint32_t>(20 * seed);
    for (auto& pixel : picture_) pixel = random.below(256) < density ? 200 : 10;
    for (int i = 0; i < 30; ++i) {
      const int x = static_cast<int>(random.below(kWidth - 40));
      const int y = static_cast<int>(random.below(kHeight - 30));
      fill(picture_, x, y, x + 39, y + 9, i % 3 ? 200 : 10);
    }
    const auto expected = by_definition(picture_, 128, 200);
    const auto found = sorted(find(picture_, {128, Polarity::kBright}, 200));
    if (finder_->overflowed()) continue;
    ++compared;
    ASSERT_EQ(found.size(), expected.size()) << "seed " << seed;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(key(found[i]), key(expected[i])) << "seed " << seed;
      EXPECT_NEAR(found[i].centroid_column_px, expected[i].centroid_column_px, 1e-9);
      EXPECT_NEAR(found[i].centroid_row_px, expected[i].centroid_row_px, 1e-9);
    }
  }
  EXPECT_GE(compared, 8);
}

TEST_F(BlobsTest, JoinsTheArmsOfAUAndOfAnUpsideDownU) {
  fill(picture_, 10, 10, 14, 60, 200);
  fill(picture_, 40, 10, 44, 60, 200);
  fill(picture_, 10, 61, 44, 64, 200);
  fill(picture_, 110, 10, 114, 60, 200);
  fill(picture_, 140, 10, 144, 60, 200);
  fill(picture_, 110, 6, 144, 9, 200);
  const auto blobs = find(picture_, {100, Polarity::kBright}, 1);
  ASSERT_EQ(blobs.size(), 2u);
  EXPECT_EQ(blobs[0].area_px, 2u * 5 * 51 + 35 * 4);
  EXPECT_EQ(blobs[1].area_px, 2u * 5 * 51 + 35 * 4);
  EXPECT_EQ(blobs[1].lowest_column_px, 127);
}

TEST_F(BlobsTest, TakesThresholdAndPolarityByTheirDefinition) {
  fill(picture_, 0, 0, kWidth - 1, kHeight - 1, 100);
  fill(picture_, 30, 30, 39, 39, 99);
  fill(picture_, 60, 30, 69, 39, 101);
  EXPECT_EQ(find(picture_, {101, Polarity::kBright}, 1).at(0).left_px, 60);
  EXPECT_EQ(find(picture_, {100, Polarity::kDark}, 1).at(0).left_px, 30);
  EXPECT_EQ(find(picture_, {100, Polarity::kBright}, 1).at(0).area_px, 352u * 186 - 100);
  EXPECT_TRUE(find(picture_, {0, Polarity::kDark}, 1).empty());
}

TEST_F(BlobsTest, KeepsWhatIsNearWhenThereIsNoRoom) {
  for (int y = 0; y < kHeight; y += 2)
    for (int x = 0; x < kWidth; x += 2) at(picture_, x, y) = 255;
  fill(picture_, 100, 180, 120, 185, 255);
  const auto blobs = find(picture_, {128, Polarity::kBright}, 20);
  EXPECT_TRUE(finder_->overflowed());
  ASSERT_FALSE(blobs.empty());
  EXPECT_EQ(blobs[0].bottom_px, kHeight - 1);
  EXPECT_GE(blobs[0].area_px, 21u * 6);
  find(Picture(kWidth * kHeight), {128, Polarity::kBright}, 1);
  EXPECT_FALSE(finder_->overflowed());
}

TEST(ThresholdMask, IsTheSameOnEveryInstructionSetOfThisMachine) {
  Random random(3);
  std::vector<std::uint8_t> pixels(1003);
  for (auto& pixel : pixels) pixel = static_cast<std::uint8_t>(random.below(256));
  for (const auto polarity : {Polarity::kBright, Polarity::kDark})
    for (const auto target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      std::vector<std::uint8_t> mask(mask_bytes(pixels.size()));
      threshold_mask(pixels, {77, polarity}, mask.data());
      for (std::size_t i = 0; i < pixels.size(); ++i)
        ASSERT_EQ((mask[i / 8] >> i % 8 & 1) != 0,
                  (pixels[i] >= 77) == (polarity == Polarity::kBright))
            << hwy::TargetName(target) << " pixel " << i;
    }
  hwy::SetSupportedTargetsForTest(0);
}

}  // namespace
}  // namespace galilean::robot
