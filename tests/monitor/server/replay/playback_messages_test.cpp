// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/replay/playback_messages.h"

#include <gtest/gtest.h>

#include "monitor/server/foxglove/foxglove_messages.h"

namespace galilean::monitor {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// To pause at twice the speed, at 0x0102030405060708 ns, as the request "ab".
const Bytes kRequest{3, 1, 0, 0, 0, 0x40, 1, 8, 7, 6, 5, 4, 3, 2, 1, 2, 0, 0, 0, 'a', 'b'};

TEST(PlaybackMessages, ARequestIsReadByteByByte) {
  const auto request = read_playback_request(kRequest);
  ASSERT_TRUE(request) << request.error().message;
  EXPECT_TRUE(request.value().pause);
  EXPECT_EQ(request.value().speed, 2);
  EXPECT_EQ(request.value().seek_ns, 0x0102030405060708u);
  EXPECT_EQ(request.value().id, "ab");
  auto without_seek = kRequest;
  without_seek[1] = 0;
  without_seek[6] = 0;
  const auto play = read_playback_request(without_seek);
  EXPECT_FALSE(play.value().pause);
  EXPECT_FALSE(play.value().seek_ns.has_value());
}

TEST(PlaybackMessages, NoCutOrForgedRequestIsTaken) {
  for (std::size_t size = 0; size < kRequest.size(); ++size)
    EXPECT_FALSE(read_playback_request(std::span(kRequest).first(size))) << size;
  for (const auto& [at, byte] : {std::pair{0, 2}, {1, 7}, {15, 3}, {18, 0xff}}) {
    auto forged = kRequest;
    forged[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(byte);
    EXPECT_FALSE(read_playback_request(forged)) << at;
  }
}

TEST(PlaybackMessages, AStateIsWrittenByteByByte) {
  const auto frame = playback_state_frame({.status = PlaybackStatus::kEnded,
                                           .now_ns = 0x0102030405060708,
                                           .speed = 0.5,
                                           .did_seek = true,
                                           .request_id = "xyz"});
  EXPECT_EQ(*frame.payload,
            (Bytes{5, 3, 8, 7, 6, 5, 4, 3, 2, 1, 0, 0, 0, 0x3f, 1, 3, 0, 0, 0, 'x', 'y', 'z'}));
  EXPECT_EQ(frame.head[0], 0x82) << "a binary frame";
}

TEST(PlaybackMessages, ServerInfoSaysFromWhenToWhenThereIsData) {
  const auto info = nlohmann::json::parse(foxglove::server_info(
      foxglove::RecordingInfo{"run.mcap", 1'700'000'000'000'000'005, 1'700'000'001'999'999'999},
      "7"));
  EXPECT_EQ(info["capabilities"], (nlohmann::json{"time", "playbackControl"}));
  EXPECT_EQ(info["dataStartTime"], (nlohmann::json{{"sec", 1'700'000'000}, {"nsec", 5}}));
  EXPECT_EQ(info["dataEndTime"], (nlohmann::json{{"sec", 1'700'000'001}, {"nsec", 999'999'999}}));
  EXPECT_EQ(info["sessionId"], "7");
}

TEST(PlaybackMessages, SchemasThatAreNoTextGoInBase64) {
  const auto schema = [](const std::string& bytes) {
    return nlohmann::json::parse(foxglove::advertise({foxglove::AdvertisedChannel{
        1, "/t", "protobuf", "a.B", "protobuf", bytes}}))["channels"][0]["schema"];
  };
  EXPECT_EQ(schema("Man"), "TWFu");
  EXPECT_EQ(schema("Ma"), "TWE=");
  EXPECT_EQ(schema("\xff"), "/w==");
  EXPECT_EQ(schema(""), "");
}

}  // namespace
}  // namespace galilean::monitor
