// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/writing/copies.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <span>

#include "core/json_text.h"
#include "monitor/logs/figures/stats.h"
#include "monitor/logs/reading/attachments.h"
#include "monitor/mcap/crc32.h"
#include "monitor/record/losses.h"
#include "monitor/record/told_losses.h"
#include "tests/monitor/logs/logged_team.h"
#include "tests/monitor/record/faulty_disk.h"

namespace galilean::logs {
namespace {

using testing::HasSubstr;

/// A recording with metadata and an attachment of 3 MB, written record by record.
mcap::Bytes with_extras() {
  mcap::Bytes bytes(std::begin(mcap::kMagic), std::end(mcap::kMagic));
  mcap::append(bytes, mcap::Header{"ros2", "test"});
  mcap::append(bytes, mcap::Metadata{"who", {{"name", "io"}}});
  const auto at = bytes.size();
  mcap::append_head(bytes, {.log_ns = 5,
                            .create_ns = 4,
                            .name = "a.bhdl",
                            .media_type = "text/plain",
                            .data_bytes = 3'000'000});
  for (int i = 0; i < 3'000'000; ++i)
    bytes.push_back(static_cast<std::uint8_t>((i % 256) * (i % 256)));
  const auto crc = mcap::crc32(mcap::ByteView(bytes).subspan(at + mcap::kRecordHead));
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(crc >> (8 * i)));
  mcap::append(bytes, mcap::DataEnd{});
  mcap::append(bytes, mcap::Footer{});
  bytes.insert(bytes.end(), std::begin(mcap::kMagic), std::end(mcap::kMagic));
  return bytes;
}

class CopiesTest : public LoggedTeam {
 protected:
  CopiesTest() { write("run.mcap", six_seconds()); }
  Answer copy(const std::string& verb, CopyOptions options) {
    for (auto& file : options.files) file = path(file);
    options.output.path = path(options.output.path);
    return answer_of([&] { return copy_recordings(verb, options); });
  }
};

TEST_F(CopiesTest, AConvertedRecordingHasTheSameMessages) {
  for (const char* compression : {"zstd", "lz4", "none"}) {
    const std::string out = std::string(compression) + ".mcap";
    const auto answer = copy(
        "convert", {.files = {"run.mcap"}, .output = {.path = out, .compression = compression}});
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_THAT(answer.out, HasSubstr("120 messages of 2 channels"));
    EXPECT_EQ(contents_of(path(out)), contents_of(path("run.mcap")));
    const auto made = Recording::open(path(out));
    EXPECT_TRUE(made.value().summary().compressions.contains(
        std::string(compression) == "none" ? "" : compression));
  }
}

TEST_F(CopiesTest, SchemasAreChangedIntoTheOtherLanguageAndBack) {
  const auto original = Recording::open(path("run.mcap"));
  const auto& schemas = original.value().summary().schemas;
  (void)copy("convert",
             {.files = {"run.mcap"}, .output = {.path = "msg.mcap", .schema = "ros2msg"}});
  (void)copy("convert",
             {.files = {"msg.mcap"}, .output = {.path = "idl.mcap", .schema = "ros2idl"}});
  const auto as_messages = Recording::open(path("msg.mcap")),
             back = Recording::open(path("idl.mcap"));
  EXPECT_EQ(contents_of(path("msg.mcap")), contents_of(path("run.mcap")));
  for (const auto& [id, schema] : as_messages.value().summary().schemas) {
    EXPECT_EQ(schema.encoding, "ros2msg");
    EXPECT_THAT(schema.data, HasSubstr("builtin_interfaces/Time stamp\n"));
  }
  ASSERT_EQ(back.value().summary().schemas.size(), schemas.size());
  for (const auto& [id, schema] : back.value().summary().schemas) {
    EXPECT_EQ(schema.encoding, "ros2idl");
    EXPECT_TRUE(std::ranges::any_of(
        schemas, [&text = schema.data](const auto& each) { return each.second.data == text; }));
  }
}

TEST_F(CopiesTest, ASchemaThatCannotBeReadStaysAsItIs) {
  mcap::FaultyDisk disk;
  mcap::Writer writer(disk);
  ASSERT_TRUE(writer.begin());
  const auto schema = writer.add_schema("a/msg/B", "protobuf", "?");
  const auto channel =
      writer.add_channel({.schema_id = schema, .topic = "/b", .message_encoding = "protobuf"});
  ASSERT_TRUE(writer.write(mcap::Message{channel, 1, 5, 5, {}}));
  ASSERT_TRUE(writer.end());
  write("other.mcap", disk.bytes());
  const auto answer = copy(
      "convert", {.files = {"other.mcap"}, .output = {.path = "out.mcap", .schema = "ros2msg"}});
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.errors, HasSubstr("the type a/msg/B, has a schema that is in the encoding"));
  EXPECT_EQ(contents_of(path("out.mcap")).size(), 1U);
}

/// Topics by name, with the name of their type and how many messages they have.
std::map<std::string, std::pair<std::string, std::uint64_t>> topics_in(const std::string& path) {
  const auto recording = Recording::open(path);
  const auto& summary = recording.value().summary();
  std::map<std::string, std::pair<std::string, std::uint64_t>> topics;
  for (const auto& [id, channel] : summary.channels) {
    const auto counted = summary.statistics.channel_messages.find(id);
    const bool is_silent = counted == summary.statistics.channel_messages.end();
    topics[channel.topic] = {summary.schemas.at(channel.schema_id).name,
                             is_silent ? 0 : counted->second};
  }
  return topics;
}

/// A recording with messages on /a, none on /b and /c, and a type that no topic has.
mcap::Bytes with_silent_channels() {
  mcap::FaultyDisk disk;
  mcap::Writer writer(disk);
  EXPECT_TRUE(writer.begin());
  std::uint16_t first = 0;
  for (const std::string topic : {"/a", "/b", "/c"}) {
    const auto schema = writer.add_schema("x/msg/Of" + topic.substr(1), "ros2msg", "bool x\n");
    const auto id = writer.add_channel(
        {.schema_id = schema, .topic = topic, .message_encoding = "cdr", .metadata = {}});
    if (first == 0) first = id;
  }
  (void)writer.add_schema("x/msg/OfNothing", "ros2msg", "bool x\n");
  for (std::uint64_t s = 1; s <= 3; ++s)
    EXPECT_TRUE(writer.write(mcap::Message{first, 1, s * 1'000'000'000, s * 1'000'000'000, {}}));
  EXPECT_TRUE(writer.end());
  return disk.bytes();
}

TEST_F(CopiesTest, ChannelsWithoutMessagesAndTheirTypesStay) {
  write("silent.mcap", with_silent_channels());
  const auto all = topics_in(path("silent.mcap"));
  ASSERT_EQ(all.size(), 3U);
  for (const bool read_again : {false, true}) {
    const auto answer =
        copy(read_again ? "recover" : "convert", {.files = {"silent.mcap"},
                                                  .output = {.path = "copy.mcap", .replace = true},
                                                  .read_again = read_again});
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_THAT(answer.out, HasSubstr("3 messages of 3 channels, of which 2 have no message, "));
    EXPECT_EQ(topics_in(path("copy.mcap")), all);
    EXPECT_EQ(Recording::open(path("copy.mcap")).value().summary().schemas.size(), 4U);
  }
  const auto merged =
      copy("merge", {.files = {"run.mcap", "silent.mcap"}, .output = {.path = "merged.mcap"}});
  EXPECT_THAT(merged.out, HasSubstr("123 messages of 5 channels, of which 2 have no message, "));
}

TEST_F(CopiesTest, ASliceKeepsTheChannelsOfTheChosenTopics) {
  write("silent.mcap", with_silent_channels());
  const auto slice_of = [&](Selection selection) {
    const auto answer = copy("slice", {.files = {"silent.mcap"},
                                       .selection = std::move(selection),
                                       .output = {.path = "slice.mcap", .replace = true}});
    EXPECT_EQ(answer.code, 0) << answer.errors;
    return topics_in(path("slice.mcap"));
  };
  EXPECT_EQ(slice_of({.from_s = 1.5}).size(), 3U);
  EXPECT_EQ(slice_of({.from_s = 1.5}).at("/a").second, 1U);
  const auto chosen = slice_of({.topics = {"a", "b"}, .from_s = 1.5});
  EXPECT_EQ(chosen.size(), 2U) << "/c was not chosen";
  EXPECT_EQ(chosen.at("/b"), std::pair(std::string("x/msg/Ofb"), std::uint64_t{0}));
}

TEST_F(CopiesTest, ASliceIsAPartOfTheMessages) {
  const auto answer = copy("slice", {.files = {"run.mcap"},
                                     .selection = {.topics = {"io/state"}, .from_s = 2, .to_s = 3},
                                     .output = {.path = "slice.mcap"}});
  EXPECT_EQ(answer.code, 0) << answer.errors;
  auto expected = contents_of(path("run.mcap"));
  std::erase_if(expected, [](const auto& each) {
    const double s =
        static_cast<double>(std::get<1>(each) - expect::RecordedTeam::kBegin_ns) * 1e-9;
    return std::get<0>(each) != "/io/state" || s < 2 || s > 3;
  });
  EXPECT_EQ(expected.size(), 11U);
  EXPECT_EQ(contents_of(path("slice.mcap")), expected);
}

TEST_F(CopiesTest, ASliceLeavesOutWhatWasCountedAsMissingOfAll) {
  expect::RecordedTeam team;
  for (int i = 0; i < 10; ++i) team.send(i, "/io/state", msg::RobotState{});
  ASSERT_TRUE(team.writer().write(mcap::Metadata{"who", {{"robot", "io"}}}));
  ASSERT_TRUE(monitor::LossLog(team.writer()).conclude({{.topic = "/io/state", .lost = 5}}));
  write("lossy.mcap", team.end());
  const auto metadata_after = [&](Selection selection) {
    (void)copy("slice", {.files = {"lossy.mcap"},
                         .selection = std::move(selection),
                         .output = {.path = "slice.mcap", .replace = true}});
    std::vector<std::string> names;
    const auto slice = Recording::open(path("slice.mcap"));
    for (const auto& metadata : slice.value().summary().metadata) names.push_back(metadata.name);
    return names;
  };
  EXPECT_THAT(metadata_after({.topics = {"/io/state"}}), testing::ElementsAre("who", "losses"));
  EXPECT_THAT(metadata_after({.from_s = 4}), testing::ElementsAre("who"));
}

TEST_F(CopiesTest, ASliceMayBeginWithTheStatesOfItsStart) {
  (void)copy("slice", {.files = {"run.mcap"},
                       .selection = {.from_s = 5.85},
                       .with_states = true,
                       .output = {.path = "slice.mcap"}});
  const auto messages = contents_of(path("slice.mcap"));
  ASSERT_EQ(messages.size(), 4U);  // the newest of both states, and two messages
  EXPECT_EQ(std::get<1>(messages[0]), expect::RecordedTeam::kBegin_ns + 5'800'000'000);
  EXPECT_EQ(std::get<1>(messages[3]), expect::RecordedTeam::kBegin_ns + 5'900'000'000);
}

TEST_F(CopiesTest, PartsMergeToTheWholeInWhateverOrderTheyAreNamed) {
  const auto part = [&](const std::string& name, double from_s, double to_s) {
    (void)copy("slice", {.files = {"run.mcap"},
                         .selection = {.from_s = from_s, .to_s = to_s},
                         .output = {.path = name}});
  };
  part("late.mcap", 3.95, 9);
  part("early.mcap", 0, 1.95);
  part("middle.mcap", 1.95, 3.95);
  const auto answer = copy("merge", {.files = {"late.mcap", "early.mcap", "middle.mcap"},
                                     .output = {.path = "merged.mcap"}});
  EXPECT_EQ(answer.code, 0) << answer.errors;
  EXPECT_THAT(answer.out, HasSubstr("of 2 channels"));
  EXPECT_EQ(contents_of(path("merged.mcap")), contents_of(path("run.mcap")));
}

TEST_F(CopiesTest, NothingThatIsThereIsOverwrittenUnasked) {
  const auto before = read("run.mcap");
  const auto onto_itself =
      copy("convert", {.files = {"run.mcap"}, .output = {.path = "run.mcap", .replace = true}});
  EXPECT_EQ(onto_itself.code, 1);
  EXPECT_THAT(onto_itself.errors, HasSubstr("is read here and cannot be written"));
  write("there.mcap", {1, 2, 3});
  EXPECT_EQ(copy("convert", {.files = {"run.mcap"}, .output = {.path = "there.mcap"}}).code, 1);
  EXPECT_EQ(
      copy("convert", {.files = {"none.mcap"}, .output = {.path = "there.mcap", .replace = true}})
          .code,
      1);
  EXPECT_EQ(read("run.mcap"), before);
  EXPECT_EQ(read("there.mcap"), (mcap::Bytes{1, 2, 3}));
}

TEST_F(CopiesTest, APartThatHoldsNothingIsAFailureAndIsNotWritten) {
  write("there.mcap", {1, 2, 3});
  const OutputOptions there{.path = "there.mcap", .replace = true};
  const auto late =
      copy("slice", {.files = {"run.mcap"}, .selection = {.from_s = 60}, .output = there});
  EXPECT_EQ(late.code, 1);
  EXPECT_EQ(late.out, "");
  EXPECT_EQ(late.errors, "galilean log slice: there is no message from 60 s on; " +
                             path("run.mcap") + " ends at 5.9 s; nothing was written\n");
  const auto between =
      copy("slice",
           {.files = {"run.mcap"},
            .selection = {.topics = {"io/state", "/io/variables"}, .from_s = 2.01, .to_s = 2.05},
            .output = {.path = "new.mcap"}});
  EXPECT_EQ(between.code, 1);
  EXPECT_EQ(between.errors,
            "galilean log slice: there is no message of io/state and /io/variables from 2.01 s on "
            "up to 2.05 s; nothing was written\n");
  EXPECT_FALSE(std::filesystem::exists(path("new.mcap")));
  EXPECT_EQ(read("there.mcap"), (mcap::Bytes{1, 2, 3}));
}

TEST_F(CopiesTest, AnEmptyRecordingIsCopiedWhole) {
  write("empty.mcap", expect::RecordedTeam().end());
  EXPECT_EQ(copy("slice", {.files = {"empty.mcap"}, .output = {.path = "copy.mcap"}}).code, 0);
  EXPECT_TRUE(contents_of(path("copy.mcap")).empty());
}

TEST_F(CopiesTest, ADamagedRecordingIsCopiedAsFarAsItCanBeRead) {
  auto bytes = six_seconds();
  expect::damage_chunk_at(2.5, bytes);
  write("run.mcap", bytes);
  const auto answer = copy("convert", {.files = {"run.mcap"}, .output = {.path = "mended.mcap"}});
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.errors, HasSubstr("damaged: the chunk at byte"));
  EXPECT_EQ(contents_of(path("mended.mcap")).size(), 100U);
}

/// What a recording tells that it lacks.
monitor::ToldLosses losses_in(const std::string& path) {
  const auto recording = Recording::open(path);
  return monitor::told_losses(recording.value().source(), recording.value().summary())
      .value_or(monitor::ToldLosses{});
}

TEST_F(CopiesTest, WhatACopyCouldNotTakeIsToldByEveryLaterReader) {
  auto bytes = six_seconds();
  expect::damage_chunk_at(2.5, bytes);
  write("dam.mcap", bytes);
  std::string from = "dam.mcap";
  for (const char* verb : {"recover", "merge", "convert"}) {
    const std::string out = std::string(verb) + ".mcap";
    EXPECT_EQ(copy(verb, {.files = {from}, .output = {.path = out}}).code, 3) << verb;
    const auto losses = losses_in(path(out));
    ASSERT_EQ(losses.copies.size(), 1U) << verb;
    EXPECT_EQ(losses.missing(), 20U) << verb;
    EXPECT_EQ(losses.copies[0].topics.at("/io/state"), 10U);
    EXPECT_EQ(losses.copies[0].file, "dam.mcap") << "it is of the first that was damaged";
    from = out;
  }
  const auto stats =
      answer_of([&] { return print_statistics({.file = path(from), .json = true}); });
  EXPECT_EQ(stats.code, 3);
  EXPECT_THAT(stats.errors, HasSubstr("20 messages are lost, which were damaged or missing in "
                                      "dam.mcap, the file that it was copied from"));
  EXPECT_EQ(read_json(stats.out).value()["topics"]["/io/state"]["missing"], 10);
}

TEST_F(CopiesTest, ACopyOfAPartLacksWhatWasLostOfThatPart) {
  auto bytes = six_seconds();
  expect::damage_chunk_at(2.5, bytes);
  write("dam.mcap", bytes);
  const auto losses_of = [&](Selection selection) {
    (void)copy("slice", {.files = {"dam.mcap"},
                         .selection = std::move(selection),
                         .output = {.path = "slice.mcap", .replace = true}});
    return losses_in(path("slice.mcap")).copies;
  };
  EXPECT_TRUE(losses_of({.from_s = 4}).empty());
  EXPECT_TRUE(losses_of({.to_s = 1}).empty());
  EXPECT_EQ(losses_of({.from_s = 1, .to_s = 4}).at(0).missing(), 20U);
  EXPECT_EQ(losses_of({.topics = {"/io/state"}}).at(0).missing(), 10U);
  write("dam.mcap", with_silent_channels());
  EXPECT_TRUE(losses_of({}).empty()) << "it is whole";
}

TEST_F(CopiesTest, ACopyOfARecordingThatWasNotClosedSaysThatMoreMayBeLost) {
  const auto whole = six_seconds();
  write("cut.mcap", {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2)});
  (void)copy("recover", {.files = {"cut.mcap"}, .output = {.path = "mended.mcap"}});
  const auto losses = losses_in(path("mended.mcap"));
  EXPECT_FALSE(losses.is_whole);
  ASSERT_EQ(losses.copies.size(), 1U);
  EXPECT_FALSE(losses.copies[0].is_exact);
}

TEST_F(CopiesTest, WhatIsRecoveredIsWholeAndSaysWhatIsNot) {
  const auto whole = six_seconds();
  const auto all = contents_of(path("run.mcap"));
  for (std::size_t bytes = 0; bytes < whole.size(); bytes += whole.size() / 200) {
    write("cut.mcap", {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(bytes)});
    const auto answer = copy("recover", {.files = {"cut.mcap"},
                                         .output = {.path = "mended.mcap", .replace = true},
                                         .read_again = true});
    ASSERT_TRUE(answer.code == 1 || answer.code == 3) << bytes << ": " << answer.errors;
    EXPECT_NE(answer.errors, "") << bytes;
    if (answer.code == 1) continue;
    const auto mended = contents_of(path("mended.mcap"));
    ASSERT_FALSE(mended.empty()) << bytes;
    EXPECT_TRUE(std::ranges::equal(mended, std::span(all).first(mended.size()))) << bytes;
  }
}

TEST_F(CopiesTest, AFlippedBitNeverMakesAWrongRecordingOfARightOne) {
  const auto whole = six_seconds();
  const auto all = contents_of(path("run.mcap"));
  for (std::size_t at = 0; at < whole.size(); at += whole.size() / 200) {
    auto bytes = whole;
    bytes[at] ^= 0x10;
    write("flipped.mcap", bytes);
    const auto answer = copy("recover", {.files = {"flipped.mcap"},
                                         .output = {.path = "mended.mcap", .replace = true},
                                         .read_again = true});
    if (answer.code == 1) continue;
    const auto mended = contents_of(path("mended.mcap"));
    EXPECT_TRUE(answer.code == 3 || mended.size() == all.size()) << at << ": " << answer.errors;
    for (const auto& message : mended) ASSERT_NE(std::ranges::find(all, message), all.end()) << at;
  }
}

TEST_F(CopiesTest, NothingToRecoverIsAFailure) {
  for (const mcap::Bytes& bytes : {mcap::Bytes{}, mcap::Bytes(5000, 7)}) {
    write("foreign.mcap", bytes);
    EXPECT_EQ(
        copy("recover",
             {.files = {"foreign.mcap"}, .output = {.path = "mended.mcap"}, .read_again = true})
            .code,
        1);
  }
}

TEST_F(CopiesTest, ADamagedAttachmentIsLeftOutAndNamed) {
  auto bytes = with_extras();
  bytes[bytes.size() / 2] ^= 1;
  write("extra.mcap", bytes);
  const auto answer = copy("convert", {.files = {"extra.mcap"}, .output = {.path = "mended.mcap"}});
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.errors, HasSubstr("'a.bhdl' is damaged and was left out"));
  EXPECT_TRUE(Recording::open(path("mended.mcap")).value().summary().attachments.empty());
}

TEST_F(CopiesTest, MetadataAndAttachmentsAreCopiedOnce) {
  write("extra.mcap", with_extras());
  const auto answer = copy("merge", {.files = {"extra.mcap", "run.mcap", "extra.mcap"},
                                     .output = {.path = "merged.mcap"}});
  EXPECT_EQ(answer.code, 0) << answer.errors;
  const auto made = Recording::open(path("merged.mcap"), mcap::Depth::kAll);
  const auto& summary = made.value().summary();
  EXPECT_FALSE(summary.recovered());
  ASSERT_EQ(summary.metadata.size(), 1U);
  EXPECT_EQ(summary.metadata[0].entries.at("name"), "io");
  ASSERT_EQ(summary.attachments.size(), 1U);
  const auto& attachment = summary.attachments[0];
  EXPECT_EQ(attachment.name, "a.bhdl");
  ASSERT_EQ(attachment.data_bytes, 3'000'000U);
  EXPECT_TRUE(is_whole(made.value().source(), attachment));
  mcap::Bytes data(4);
  ASSERT_TRUE(made.value().source().read(attachment.data_offset + 250, data));
  EXPECT_EQ(data, (mcap::Bytes{36, 25, 16, 9}));  // (250 - 256)² and so on
}

}  // namespace
}  // namespace galilean::logs
