// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/replay/viewer_playback.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "monitor/mcap/byte_sink.h"
#include "tests/monitor/recordings/written_recording.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint64_t kStart_ns = 1'700'000'000'000'000'000;

/// What a viewer heard, in its order: "state playing 3 a" is a playback state at 3 s that answers
/// "a", and "message 2" one of 2 s.
class Heard {
 public:
  std::vector<std::string> lines;
  std::vector<json> texts;
  std::vector<double> times_s;

  void take(const ForViewer& what) {
    for (const auto& frame : what.frames) read(frame);
    if (what.time) times_s.push_back(seconds(bytes_of(*what.time), 1));
  }

 private:
  static std::vector<std::uint8_t> bytes_of(const Frame& frame) {
    const auto head = frame.head_bytes();
    const std::size_t web_socket = head[1] < 126 ? 2 : head[1] == 126 ? 4 : 10;
    std::vector<std::uint8_t> bytes(head.begin() + static_cast<std::ptrdiff_t>(web_socket),
                                    head.end());
    if (frame.payload) bytes.insert(bytes.end(), frame.payload->begin(), frame.payload->end());
    return bytes;
  }
  static double seconds(const std::vector<std::uint8_t>& bytes, std::size_t at) {
    std::uint64_t log_ns = 0;
    for (std::size_t i = 0; i < 8; ++i) log_ns |= std::uint64_t{bytes.at(at + i)} << (8 * i);
    return static_cast<double>(log_ns - kStart_ns) * 1e-9;
  }
  static std::string short_number(double number) {
    std::ostringstream text;
    text << number;
    return text.str();
  }
  void read(const Frame& frame) {
    const auto bytes = bytes_of(frame);
    if (frame.head[0] == 0x81) {
      texts.push_back(json::parse(bytes.begin(), bytes.end()));
      lines.push_back(texts.back()["op"]);
    } else if (bytes[0] == 1) {
      lines.push_back("message " + short_number(seconds(bytes, 5)));
    } else if (bytes[0] == 5) {
      static constexpr const char* kNames[] = {"playing", "paused", "buffering", "ended"};
      const std::string id(bytes.begin() + 19, bytes.end());
      lines.push_back(std::string("state ") + kNames[bytes[1]] + " " +
                      short_number(seconds(bytes, 2)) + (bytes[14] ? " sought" : "") +
                      (id.empty() ? "" : " " + id));
    }
  }
};

class ViewerPlaybackTest : public testing::Test {
 protected:
  void open(const mcap::Bytes& bytes, double at_s = 0) {
    write_file(inside / "run.mcap", bytes);
    auto opened = ViewedRecording::open(folder, "run.mcap");
    ASSERT_TRUE(opened) << opened.error().message;
    recording.emplace(std::move(opened).value());
    playback.emplace(*recording, line, clock, from_seconds(at_s));
  }
  /// Lets time pass, as the playback asks for it.
  void pass(double for_s) {
    const Time end = clock.now() + from_seconds(for_s);
    auto rest = playback->step();
    while (clock.now() < end) {
      clock.advance(std::clamp(rest, Duration(1000), end - clock.now()));
      rest = playback->step();
    }
  }
  std::vector<std::string> heard_since(std::size_t before) const {
    return {heard.lines.begin() + static_cast<std::ptrdiff_t>(before), heard.lines.end()};
  }
  void order(PlaybackOrder what) { ASSERT_TRUE(line.order(std::move(what))); }
  void ask(const std::string& id, bool pause, std::optional<double> seek_s = {}, float speed = 1) {
    PlaybackRequest request{.pause = pause, .speed = speed, .id = id};
    if (seek_s) request.seek_ns = kStart_ns + static_cast<std::uint64_t>(*seek_s * 1e9);
    order(request);
  }

  TemporaryFolder inside;
  RecordingFolder folder{inside.path()};
  SteppedClock clock;
  Heard heard;
  bool reads = true;
  PlaybackLine line{[this](const ForViewer& what) {
    heard.take(what);
    std::size_t bytes = 0;
    for (const auto& frame : what.frames) bytes += frame.size();
    if (reads) line.taken(bytes);
  }};
  std::optional<ViewedRecording> recording;
  std::optional<ViewerPlayback> playback;
};

TEST_F(ViewerPlaybackTest, GreetsAndWaitsForTheFirstSubscription) {
  open(recording_of_states("io", 5));
  EXPECT_THAT(heard.lines, ElementsAre("serverInfo", "advertise", "state buffering 0"));
  EXPECT_THAT(heard.texts[0]["name"].get<std::string>(),
              HasSubstr("run.mcap, recorded 2023-11-14T22:13:20"));
  ASSERT_EQ(heard.texts[1]["channels"].size(), 1u);
  EXPECT_EQ(heard.texts[1]["channels"][0]["topic"], "/io/state");
  pass(0.5);
  order(Subscribe{.subscription_id = 7, .channel_id = 1});
  pass(2.5);
  EXPECT_THAT(heard_since(3),
              ElementsAre("message 0", "state playing 0", "message 1", "message 2"));
}

TEST_F(ViewerPlaybackTest, ASeekIsAnsweredFirstThenComesWhatWasSoThen) {
  open(recording_of_states("io", 60));
  order(Subscribe{.subscription_id = 7, .channel_id = 1});
  pass(0.1);
  const auto before = heard.lines.size();
  ask("x", true, 40.5);
  pass(5);
  EXPECT_THAT(heard_since(before), ElementsAre("state paused 40.5 sought x", "message 40"));
  EXPECT_NEAR(heard.times_s.back(), 40.5, 1e-6);
  ask("y", false);
  pass(0.6);
  EXPECT_THAT(heard_since(before + 2), ElementsAre("state playing 40.5 y", "message 41"));
}

TEST_F(ViewerPlaybackTest, OfManySeeksAtOnceTheLastCountsAndAllAreAnswered) {
  open(recording_of_states("io", 60));
  order(Subscribe{.subscription_id = 7, .channel_id = 1});
  pass(0.1);
  const auto before = heard.lines.size();
  ask("a", true, 10.5);
  ask("b", true, 20.5);
  ask("c", true, 30.5);
  pass(0.1);
  const auto lines = heard_since(before);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_THAT(lines[0], HasSubstr(" sought a"));
  EXPECT_THAT(lines[1], HasSubstr(" sought b"));
  EXPECT_EQ(lines[2], "state paused 30.5 sought c");
  EXPECT_EQ(lines[3], "message 30");
}

TEST_F(ViewerPlaybackTest, PlaysToTheEndAndSaysSo) {
  open(recording_of_states("io", 5));
  order(Subscribe{.subscription_id = 7, .channel_id = 1});
  ask("fast", false, {}, 100);
  pass(1);
  EXPECT_EQ(heard.lines.back(), "state ended 4");
  ask("slow", false, {}, 0.05F);
  pass(0.1);
  EXPECT_THAT(heard.texts.back()["message"].get<std::string>(), HasSubstr("from 0.1 to 100"));
  EXPECT_EQ(heard.lines.back(), "state ended 4 slow");
}

TEST_F(ViewerPlaybackTest, BeginsWhereItIsAsked) {
  open(recording_of_states("io", 60), 30.5);
  order(Subscribe{.subscription_id = 7, .channel_id = 1});
  pass(0.6);
  EXPECT_THAT(heard_since(3), ElementsAre("message 30", "state playing 30.5", "message 31"));
}

TEST_F(ViewerPlaybackTest, WrongOrdersAreAnswered) {
  open(recording_of_states("io", 5));
  order(Subscribe{.subscription_id = 7, .channel_id = 99});
  order(Unsubscribe{.subscription_id = 3});
  order(Subscribe{.subscription_id = 7, .channel_id = 1});
  order(Subscribe{.subscription_id = 7, .channel_id = 1});
  pass(0.01);
  std::vector<std::string> said;
  for (const auto& text : heard.texts)
    if (text["op"] == "status") said.push_back(text["message"]);
  EXPECT_THAT(said, ElementsAre("There is no channel 99.", "There is no subscription 3.",
                                "Subscription id 7 is in use already."));
}

TEST_F(ViewerPlaybackTest, WaitsForAViewerThatDoesNotRead) {
  open(recording_of_states("io", 5000, kStart_ns, 1000));
  order(Subscribe{.subscription_id = 7, .channel_id = 1});
  pass(0.01);
  reads = false;
  ask("fast", false, {}, 100);
  pass(30);
  const auto stuck = heard.lines.size();
  EXPECT_LT(stuck, 1500u) << "what waits is bounded";
  const double stuck_s = heard.times_s.back();
  pass(60);
  EXPECT_EQ(heard.lines.size(), stuck);
  EXPECT_NEAR(heard.times_s.back(), stuck_s, 1) << "its time stands still";
  for (int i = 0; i < 1000; ++i) order(Unsubscribe{.subscription_id = 9});
  pass(1);
  EXPECT_EQ(heard.lines.size(), stuck) << "nothing is answered that would only wait";
  reads = true;
  line.taken(PlaybackLine::kMostWaitingBytes * 2);
  pass(0.02);
  EXPECT_GT(heard.lines.size(), stuck);
  EXPECT_LT(heard.times_s.back(), stuck_s + 10) << "it does not catch up";
}

TEST_F(ViewerPlaybackTest, TellsDamageWithItsTime) {
  auto bytes = recording_of_states("io", 60);
  const auto blocks = mcap::summarize(mcap::MemorySource(bytes)).value().blocks;
  bytes[blocks[3].offset + mcap::kRecordHead + 24] ^= 0xff;  // the checksum
  open(bytes);
  std::vector<std::string> said;
  for (const auto& text : heard.texts)
    if (text["op"] == "status") {
      EXPECT_GE(text["level"], 1);
      said.push_back(text["message"]);
    }
  ASSERT_FALSE(said.empty());
  EXPECT_THAT(said[0], HasSubstr("does not match its checksum"));
  EXPECT_THAT(said[0], HasSubstr("from 2023-11-14T22:13:"));
  order(Subscribe{.subscription_id = 7, .channel_id = 1});
  ask("fast", false, {}, 100);
  const auto before = heard.texts.size();
  pass(2);
  EXPECT_EQ(heard.texts.size(), before) << "it is told once";
}

TEST_F(ViewerPlaybackTest, SaysWhetherOneThatHasNoEndIsBeingWritten) {
  const auto bytes = recording_of_states("io", 60);
  const auto half = std::span(bytes).first(bytes.size() / 2);
  const auto said_of = [&](const std::string& name) {
    const auto opened = ViewedRecording::open(folder, name);
    return opened ? DamageTeller(opened.value()).known().at(0) : opened.error().message;
  };
  {
    auto sink = mcap::FileSink::create((inside / "now.mcap").string(), false);
    ASSERT_TRUE(sink && sink.value().write(half));
    EXPECT_EQ(said_of("now.mcap"), "'now.mcap' is being written; what it has so far is played.");
  }
  EXPECT_EQ(said_of("now.mcap"),
            "'now.mcap' was not closed properly; what can be read of it is played.");
}

TEST_F(ViewerPlaybackTest, SaysWhatCannotBePlayed) {
  const auto why = [&](const std::string& name) {
    return ViewedRecording::open(folder, name).error().message;
  };
  write_file(inside / "empty.mcap", {});
  write_file(inside / "bare.mcap", recording_of_states("io", 0));
  write_file(inside / "text.mcap", {'n', 'o', ' ', 'r', 'e', 'c', 'o', 'r', 'd'});
  EXPECT_EQ(why("nothing.mcap"), "There is no recording 'nothing.mcap' here.");
  EXPECT_EQ(why("empty.mcap"), "'empty.mcap' is empty: nothing was recorded.");
  EXPECT_EQ(why("bare.mcap"), "'bare.mcap' has no message that can be played.");
  EXPECT_EQ(why("text.mcap"), "'text.mcap' is not an MCAP file.");
}

}  // namespace
}  // namespace galilean::monitor
