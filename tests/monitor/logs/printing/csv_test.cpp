// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/printing/csv.h"

#include <gmock/gmock.h>

#include <cmath>

#include "monitor/logs/printing/columns.h"
#include "tests/monitor/logs/logged_team.h"

namespace galilean::logs {
namespace {

using monitor::MessageTree;
using testing::ElementsAre;
using testing::HasSubstr;

class CsvTest : public LoggedTeam {
 protected:
  CsvTest() { write("run.mcap", six_seconds()); }
  Answer csv(CsvOptions options) {
    options.file = path("run.mcap");
    return answer_of([&] { return print_csv(options); });
  }
};

TEST_F(CsvTest, HasAColumnForEachValueOfTheLongestList) {
  const auto answer =
      csv({.topic = "io/variables", .fields = {"items"}, .from_s = 2.85, .to_s = 3.05});
  EXPECT_EQ(answer.code, 0) << answer.errors;
  const auto end = answer.out.find("\r\n");
  EXPECT_THAT(answer.out.substr(0, end),
              testing::StartsWith("at_s,log_time,items[0].name,items[0].type,"));
  EXPECT_THAT(answer.out.substr(0, end), HasSubstr(",items[1].name,"));
  EXPECT_THAT(answer.out, HasSubstr("2.900000000,2023-11-14T22:13:22.900Z,\"v,0\","));
  EXPECT_THAT(answer.out, HasSubstr("\"v,1\""));
}

TEST_F(CsvTest, PrintsChosenFields) {
  const auto answer = csv({.topic = "/io/state", .fields = {"tick", "state"}, .from_s = 5.75});
  EXPECT_EQ(answer.out,
            "at_s,log_time,tick,state\r\n"
            "5.800000000,2023-11-14T22:13:25.800Z,58,stuck\r\n"
            "5.900000000,2023-11-14T22:13:25.900Z,59,stuck\r\n");
}

TEST_F(CsvTest, AsksForATopicIfThereAreSeveral) {
  const auto answer = csv({});
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.errors, HasSubstr("has several topics; name one of /io/state, /io/variables"));
}

TEST(Columns, StandWhereTheirValuesStandInTheMessages) {
  Columns columns;
  EXPECT_TRUE(columns.add(MessageTree::parse(R"({"a":[1],"b":{"c":2}})"), ""));
  EXPECT_TRUE(columns.add(MessageTree::parse(R"({"a":[1,2],"b":{"c":2}})"), ""));
  EXPECT_THAT(columns.names(), ElementsAre("a[0]", "a[1]", "b.c"));
  EXPECT_EQ(columns.place_of("b.c"), 2U);
}

TEST(Columns, AreNotWithoutNumber) {
  Columns columns;
  EXPECT_FALSE(columns.add(MessageTree(std::vector<int>(5000, 1)), "data"));
}

TEST(CsvCell, IsQuotedWhereItMustBe) {
  EXPECT_EQ(csv_cell("a"), "a");
  EXPECT_EQ(csv_cell("a,\"b\"\n"), "\"a,\"\"b\"\"\n\"");
  EXPECT_EQ(csv_cell(0.1), "0.1");
  EXPECT_EQ(csv_cell(std::nan("")), "nan");
  EXPECT_EQ(csv_cell(nullptr), "");
  EXPECT_EQ(csv_cell(true), "true");
  EXPECT_EQ(csv_cell(std::uint64_t{1} << 63), "9223372036854775808");
}

}  // namespace
}  // namespace galilean::logs
