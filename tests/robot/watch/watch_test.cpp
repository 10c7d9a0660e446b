// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "robot/executive/opened_devices.h"
#include "robot/watch/program_watch.h"
#include "tests/robot/executive/test_robot.h"
#include "tests/temporary_folder.h"

namespace galilean::robot {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A program of one state.
std::string with_state(const std::string& name) {
  return "state: name: \"" + name + "\" end\n";
}

/// All that was logged, readable while more is.
class Lines final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  std::string text() {
    const std::lock_guard lock(mutex_);
    return text_;
  }

 private:
  void sink_it_(const spdlog::details::log_msg& line) override {
    text_.append(line.payload.data(), line.payload.size()).append("\n");
  }
  void flush_() override {}

  std::string text_;
};

class WatchTest : public testing::Test {
 protected:
  WatchTest() : file(folder / "my.bhdl") {
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("watch", log));
    write(file, with_state("first"));
  }
  ~WatchTest() override {
    watch.reset();
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("none"));
  }

  void start() {
    auto checked = bhdl::check_file(file, test_components().catalog());
    ASSERT_TRUE(checked.program);
    ASSERT_TRUE(robot.executive->load(std::move(*checked.program)));
    robot.tick();
    watch.emplace(file, test_components().catalog(), *robot.executive,
                  [this](const std::string& problem) {
                    const std::lock_guard lock(told_mutex);
                    told_problem = problem;
                  });
  }
  /// Waits until that was told last; an empty text: that all is well.
  [[nodiscard]] bool comes_to_tell(const std::string& part) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    const auto is_told = [&] {
      const std::lock_guard lock(told_mutex);
      return part.empty() ? told_problem.empty() : told_problem.find(part) != std::string::npos;
    };
    while (!is_told() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    return is_told();
  }
  static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
  static void write_aside_and_rename(const fs::path& path, const std::string& text) {
    const fs::path aside = path.string() + "~new";
    write(aside, text);
    fs::rename(aside, path);
  }
  /// Starts with the file in a folder of its own, and returns that folder.
  fs::path start_in_a_folder() {
    const fs::path place = folder / "place";
    fs::create_directory(place);
    file = place / "my.bhdl";
    write(file, with_state("first"));
    start();
    return place;
  }
  /// Ticks until that state is current; the file system tells when it likes.
  [[nodiscard]] bool comes_to(const std::string& state) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (robot.state() != state && std::chrono::steady_clock::now() < end) {
      robot.tick();
      std::this_thread::yield();
    }
    return robot.state() == state;
  }
  [[nodiscard]] int swaps() const { return robot.events.count(Event::Kind::kSwapped); }

  TemporaryFolder folder;
  fs::path file;
  std::shared_ptr<Lines> log = std::make_shared<Lines>();
  TestRobot robot;
  std::mutex told_mutex;
  std::string told_problem;
  std::optional<ProgramWatch> watch;
};

TEST_F(WatchTest, SwapsOnEachSaveInPlaceAndIsInProbation) {
  start();
  for (const std::string state : {"second", "third", "fourth"}) {
    write(file, with_state(state));
    EXPECT_TRUE(comes_to(state));
  }
  EXPECT_EQ(swaps(), 3);
  EXPECT_TRUE(robot.events.in_probation);
}

TEST_F(WatchTest, SwapsWhenAnEditorWritesANewFileAndRenamesIt) {
  start();
  for (const std::string state : {"second", "third"}) {
    write_aside_and_rename(file, with_state(state));
    EXPECT_TRUE(comes_to(state));
  }
}

TEST_F(WatchTest, SwapsWhenAnEditorTakesTheOldFileAwayFirst) {
  start();
  fs::rename(file, file.string() + "~");
  robot.tick(5);
  write(file, with_state("second"));
  EXPECT_TRUE(comes_to("second"));
  fs::remove(file);
  robot.tick(5);
  fs::create_hard_link(file.string() + "~", file);
  EXPECT_TRUE(comes_to("first"));
}

TEST_F(WatchTest, SwapsWhenAnIncludeIsSavedEvenOneThatCameLater) {
  fs::create_directory(folder / "parts");
  write(folder / "parts/a.bhdl", with_state("first"));
  write(file, "include \"parts/a.bhdl\"");
  start();
  write_aside_and_rename(folder / "parts/a.bhdl", with_state("second"));
  EXPECT_TRUE(comes_to("second"));
  write(folder / "b.bhdl", with_state("third"));
  write(file, "include \"b.bhdl\"");
  EXPECT_TRUE(comes_to("third"));
  write(folder / "b.bhdl", with_state("fourth"));
  EXPECT_TRUE(comes_to("fourth"));
}

TEST_F(WatchTest, FollowsALink) {
  fs::create_directory(folder / "elsewhere");
  const fs::path target = folder / "elsewhere/target.bhdl";
  fs::rename(file, target);
  fs::create_symlink(target, file);
  start();
  write_aside_and_rename(target, with_state("second"));
  EXPECT_TRUE(comes_to("second"));
}

/// Makes `link` lead to `folder` in one step, as `ln -sfn` and Kubernetes' ConfigMaps do.
void flip(const fs::path& link, const fs::path& folder) {
  const fs::path aside = link.string() + "_new";
  fs::create_directory_symlink(folder, aside);
  fs::rename(aside, link);
}

TEST_F(WatchTest, FollowsALinkToAFolderThatIsFlipped) {
  for (const std::string state : {"first", "second", "third"}) {
    fs::create_directory(folder / state);
    write(folder / state / "my.bhdl", with_state(state));
  }
  flip(folder / "current", "first");
  file = folder / "current/my.bhdl";
  start();
  flip(folder / "current", "second");
  EXPECT_TRUE(comes_to("second"));
  fs::remove_all(folder / "first");
  flip(folder / "current", folder / "third");
  EXPECT_TRUE(comes_to("third"));
  write(folder / "third/my.bhdl", with_state("fourth"));
  EXPECT_TRUE(comes_to("fourth"));
  EXPECT_TRUE(comes_to_tell(""));
}

TEST_F(WatchTest, FollowsALinkToAFileInAFolderThatIsFlipped) {
  for (const std::string state : {"first", "second", "third"}) {
    fs::create_directory(folder / ("..day " + state));
    write(folder / ("..day " + state) / "my.bhdl", with_state(state));
  }
  fs::remove(file);
  flip(folder / "..data", "..day first");
  fs::create_symlink("..data/my.bhdl", file);
  start();
  for (const std::string state : {"second", "third"}) {
    flip(folder / "..data", "..day " + state);
    EXPECT_TRUE(comes_to(state));
  }
}

TEST_F(WatchTest, FindsAFolderAgainThatWasReplaced) {
  const fs::path place = start_in_a_folder();
  fs::rename(place, folder / "old place");
  fs::create_directory(place);
  write(file, with_state("second"));
  EXPECT_TRUE(comes_to("second"));
  fs::remove_all(place);
  fs::create_directory(place);
  write(file, with_state("third"));
  EXPECT_TRUE(comes_to("third"));
}

TEST_F(WatchTest, TellsWhenAFolderIsWatchedOnlyFromNowOn) {
  const fs::path place = folder / "place";
  fs::create_directory(place);
  write(place / "my.bhdl", with_state("first"));
  FileWatch files;
  EXPECT_TRUE(files.add({place / "my.bhdl"}));
  EXPECT_FALSE(files.add({place / "my.bhdl"}));
  fs::rename(place, folder / "old place");
  fs::create_directory(place);
  EXPECT_TRUE(files.add({place / "my.bhdl"})) << "another folder of the same name";
  EXPECT_FALSE(files.add({place / "my.bhdl"}));
}

TEST_F(WatchTest, ASaveIsNoticedHoweverCloselyItFollowsAnother) {
  const fs::path place = start_in_a_folder();
  // The folder is replaced while the watch is still at the save before: a race, so it is run often.
  constexpr int kTimes = 100;
  for (int i = 0; i < kTimes; ++i) {
    const std::string state = "state " + std::to_string(i);
    fs::remove_all(place);
    fs::create_directory(place);
    write(file, with_state(state));
    ASSERT_TRUE(comes_to(state)) << "after save " << i;
  }
}

TEST_F(WatchTest, TellsThatAFolderIsGoneAndWhenItIsBack) {
  const fs::path place = start_in_a_folder();
  fs::remove_all(place);
  EXPECT_TRUE(comes_to_tell(place.string() + " are not noticed (No such file or directory): make"));
  fs::create_directory(place);
  EXPECT_TRUE(comes_to_tell(""));
  write(file, with_state("second"));
  EXPECT_TRUE(comes_to("second"));
}

TEST_F(WatchTest, OutlivesALinkToItselfWhereTheFileWas) {
  const fs::path place = start_in_a_folder();
  fs::rename(place, folder / "old place");
  EXPECT_TRUE(comes_to_tell("are not noticed"));
  fs::create_directory(folder / "new place");
  fs::create_symlink("my.bhdl", folder / "new place/my.bhdl");
  fs::rename(folder / "new place", place);
  EXPECT_TRUE(comes_to_tell(""));
  fs::remove(file);
  write(file, with_state("second"));
  EXPECT_TRUE(comes_to("second"));
}

/// As a user who is not root: root may read everything.
struct OrdinaryUser {
  OrdinaryUser() { change_to(kNobody); }
  ~OrdinaryUser() { change_to(0); }
  static void change_to(uid_t user) {
    if (getuid() == 0 && seteuid(user) != 0) ADD_FAILURE() << "cannot become user " << user;
  }
  static constexpr uid_t kNobody = 65534;
};

TEST_F(WatchTest, TellsThatAFolderMayNotBeRead) {
  const fs::path place = folder / "place";
  fs::create_directory(place);
  fs::permissions(folder.path(), fs::perms::all);
  file = place / "my.bhdl";
  write(file, with_state("first"));
  start();
  {
    const OrdinaryUser user;
    fs::rename(place, folder / "old place");
    fs::create_directory(place);
    fs::permissions(place, fs::perms::none);
    EXPECT_TRUE(comes_to_tell("(Permission denied): give this user the right to read"));
    fs::permissions(place, fs::perms::all);
    EXPECT_TRUE(comes_to_tell(""));
    write(file, with_state("second"));
    EXPECT_TRUE(comes_to("second"));
  }
}

TEST_F(WatchTest, TellsWhatItCannotDoAndDoesItLater) {
  std::atomic<int> attempts{0};
  robot.on_waiting = [&] {
    if (++attempts == 2) throw std::runtime_error("no room");
  };
  start();
  write(file, with_state("second"));
  EXPECT_TRUE(comes_to_tell("my.bhdl was saved, but could not be loaded (no room)"));
  EXPECT_TRUE(comes_to("second"));
  write(file, with_state("third"));
  EXPECT_TRUE(comes_to("third"));
  EXPECT_TRUE(comes_to_tell(""));
}

TEST_F(WatchTest, ABrokenSaveChangesNothingAndSaysWhy) {
  start();
  write(file, "state: nmae: \"second\" end\n");
  write(folder / "other.bhdl", with_state("other"));
  write(file, with_state("third"));
  EXPECT_TRUE(comes_to("third"));
  EXPECT_EQ(swaps(), 1);
  write(file, "state: nmae: \"fourth\" end\n");
  // The next good one comes after it, in the same thread.
  write(file, with_state("fifth"));
  EXPECT_TRUE(comes_to("fifth"));
  EXPECT_EQ(swaps(), 2);
}

TEST_F(WatchTest, ASaveForOtherDevicesChangesNothingAndSaysWhy) {
  const OpenedDevices opened{.camera = "a.jpg"};
  robot.admits = [opened](const bhdl::Program& program) {
    return opened.accept(program, test_components().catalog());
  };
  start();
  write_aside_and_rename(
      file, "input_devices: frame_grabber: device: \"b.jpg\" end end\n" + with_state("second"));
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  const auto told = [this] { return log->text().find("cannot run") != std::string::npos; };
  while (!told() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  EXPECT_THAT(log->text(), HasSubstr("frame_grabber is 'b.jpg' in this program, and this robot "
                                     "runs on 'a.jpg'"));
  robot.tick(3);
  EXPECT_EQ(robot.state(), "first");
  write_aside_and_rename(file, with_state("third"));
  EXPECT_TRUE(comes_to("third"));
}

TEST_F(WatchTest, SaysWhereASaveIsBroken) {
  start();
  write(file, "state: nmae: \"second\" end\n");
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  const auto told = [this] { return log->text().find("goes on") != std::string::npos; };
  while (!told() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  watch.reset();
  EXPECT_THAT(log->text(), HasSubstr("my.bhdl:1:8: error: "));
  EXPECT_THAT(log->text(), HasSubstr("goes on"));
  robot.tick(3);
  EXPECT_EQ(robot.state(), "first");
}

TEST_F(WatchTest, ATextThatIsSavedAgainBeforeItRunsSwapsOnce) {
  start();
  for (int round = 0; round < 10; ++round) {
    const std::string state = "state" + std::to_string(round);
    for (int save = 0; save < 5; ++save) write_aside_and_rename(file, with_state(state));
    EXPECT_TRUE(comes_to(state));
  }
  write_aside_and_rename(file, with_state("last"));
  EXPECT_TRUE(comes_to("last"));
  EXPECT_EQ(swaps(), 11);
}

TEST_F(WatchTest, ASaveThatChangesNothingSwapsNothing) {
  start();
  write(file, with_state("first"));
  write_aside_and_rename(file, with_state("first"));
  write(file, with_state("second"));
  EXPECT_TRUE(comes_to("second"));
  EXPECT_EQ(swaps(), 1);
}

}  // namespace
}  // namespace galilean::robot
