// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/opencv_source.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <opencv2/videoio.hpp>
#include <string>

#include "robot/devices/frame_sources.h"
#include "tests/temporary_folder.h"

namespace galilean::robot {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A portable pixmap of 4:3, of one colour, with a green column at each side that is cut off again
/// when it is made wider than that.
void write_picture(const std::filesystem::path& path, int margin) {
  constexpr int width = 640, height = 480;
  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << width + 2 * margin << ' ' << height << "\n255\n";
  for (int y = 0; y < height; ++y)
    for (int x = -margin; x < width + margin; ++x) {
      const bool outside = x < 0 || x >= width;
      file.write(outside ? "\x00\xff\x00" : "\xc8\x1e\x0a", 3);
    }
}

class OpencvSource : public testing::Test {
 protected:
  std::unique_ptr<FrameSource> make() {
    auto source = make_frame_source(path);
    EXPECT_TRUE(source.ok()) << source.error().message;
    return std::move(source).value();
  }

  TemporaryFolder folder;
  std::filesystem::path path = folder / "picture.ppm";
  std::unique_ptr<Frame> frame = std::make_unique<Frame>();
  Time now{std::chrono::seconds(10)};
};

TEST_F(OpencvSource, APictureFileComesInRedGreenBlueAgainAndAgain) {
  write_picture(path, 100);
  const auto source = make();
  ASSERT_TRUE(source->grab(*frame, now)) << source->problem();
  for (const int pixel : {0, Frame::kWidth - 1, Frame::kWidth * Frame::kHeight - 1}) {
    const auto at = static_cast<std::size_t>(pixel) * 3;
    EXPECT_EQ(frame->rgb[at], 200);
    EXPECT_EQ(frame->rgb[at + 1], 30);
    EXPECT_EQ(frame->rgb[at + 2], 10);
  }
  EXPECT_FALSE(source->grab(*frame, now + std::chrono::milliseconds(50)));
  EXPECT_TRUE(source->grab(*frame, now + std::chrono::milliseconds(101)));
}

/// Four pictures at 20 Hz, each redder than the one before.
void write_video(const std::filesystem::path& path) {
  cv::VideoWriter video(path.string(), cv::CAP_OPENCV_MJPEG,
                        cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 20, {320, 240});
  ASSERT_TRUE(video.isOpened());
  for (int i = 0; i < 4; ++i)
    video.write(cv::Mat(240, 320, CV_8UC3, cv::Scalar(20, 20, 60 + 50 * i)));
}

TEST_F(OpencvSource, AVideoRunsAtItsOwnRateAndBeginsAgain) {
  path.replace_extension(".avi");
  write_video(path);
  const auto source = make();
  for (const int red : {60, 110, 160, 210, 60, 110}) {
    ASSERT_TRUE(source->grab(*frame, now)) << source->problem();
    EXPECT_NEAR(frame->rgb[0], red, 8);
    EXPECT_NEAR(frame->rgb[2], 20, 8);
    EXPECT_FALSE(source->grab(*frame, now + std::chrono::milliseconds(45)));
    now += std::chrono::milliseconds(51);
  }
}

TEST_F(OpencvSource, AMissingFileIsNamedAndFoundWhenItComes) {
  const auto source = make();
  EXPECT_FALSE(source->grab(*frame, now));
  EXPECT_NE(source->problem().find(path.string()), std::string::npos) << source->problem();
  write_picture(path, 0);
  EXPECT_FALSE(source->grab(*frame, now + std::chrono::milliseconds(500)));
  EXPECT_TRUE(source->grab(*frame, now + std::chrono::milliseconds(1001)));
  EXPECT_EQ(source->problem(), "");
}

TEST_F(OpencvSource, APathThatCannotEvenBeLookedForIsNamedWithWhatToDo) {
  fs::create_symlink("loop.ppm", folder / "loop.ppm");
  for (const fs::path& bad : {fs::path(std::string(300, 'x')), folder / "loop.ppm"}) {
    path = bad;
    const auto source = make();
    EXPECT_FALSE(source->grab(*frame, now));
    EXPECT_THAT(source->problem(), HasSubstr(path.string() + " cannot be looked for ("));
    EXPECT_THAT(source->problem(), HasSubstr("name another one in frame_grabber"));
  }
}

TEST_F(OpencvSource, AFileThatIsNoPictureIsNamed) {
  std::ofstream(path) << "no picture";
  const auto source = make();
  EXPECT_FALSE(source->grab(*frame, now));
  EXPECT_NE(source->problem().find("cannot be opened"), std::string::npos) << source->problem();
}

}  // namespace
}  // namespace galilean::robot
