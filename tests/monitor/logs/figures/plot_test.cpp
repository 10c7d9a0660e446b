// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/plot.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <limits>

#include "monitor/logs/figures/chart.h"
#include "tests/monitor/logs/logged_team.h"

namespace galilean::logs {
namespace {

using testing::HasSubstr;

TEST(Series, KeepsTheRangeOfEachSpanHoweverLongItGrows) {
  Series series;
  constexpr int kValues = 1'000'000;
  for (int i = 0; i < kValues; ++i) series.add(0.1 * i, i == 750'000 ? 5.0 : i % 2 ? 1.0 : -1.0);
  EXPECT_EQ(series.count(), std::uint64_t{kValues});
  const auto columns = series.columns(0, series.last_s(), 10);
  ASSERT_EQ(columns.size(), 10U);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    EXPECT_EQ(columns[i].least, -1) << i;
    EXPECT_EQ(columns[i].most, i == 7 ? 5 : 1) << i;
  }
}

TEST(Chart, DrawsALineFromBelowToAbove) {
  NamedSeries one{"io/state.x_m", {}};
  for (int i = 0; i < 10; ++i) one.series.add(i, i);
  EXPECT_EQ(chart_text({one}, 10, 4),
            "* io/state.x_m: 0 to 9\n"
            "         9 |        **\n"
            "           |     ***\n"
            "           |  ***\n"
            "         0 |**\n"
            "           +----------\n"
            "            0 s    9 s\n");
}

TEST(Chart, DrawsAConstantInTheMiddle) {
  NamedSeries one{"a", {}}, two{"b", {}};
  one.series.add(0, 1);
  two.series.add(0, 1);
  EXPECT_THAT(chart_text({one, two}, 10, 3), HasSubstr("           |b\n"));
}

TEST(Chart, DrawsTheLargestNumbers) {
  NamedSeries one{"a", {}};
  for (int i = 0; i < 10; ++i) one.series.add(i, i < 5 ? -1e308 : i < 9 ? 0 : 1e308);
  EXPECT_EQ(chart_text({one}, 10, 3),
            "* a: -1e+308 to 1e+308\n"
            "    1e+308 |         *\n"
            "           |     ****\n"
            "   -1e+308 |*****\n"
            "           +----------\n"
            "            0 s    9 s\n");
  const auto svg = svg_of(chart_drawing({one}));
  EXPECT_THAT(svg, testing::Not(testing::AnyOf(HasSubstr("nan"), HasSubstr("inf"))));
  EXPECT_THAT(svg, testing::AllOf(HasSubstr(",60 "), HasSubstr(",180 "), HasSubstr(",300")));
}

TEST(Chart, LabelsStayWithinTheirColumn) {
  NamedSeries one{"a", {}};
  one.series.add(0, -1.2345678e-300);
  one.series.add(1, std::numeric_limits<double>::max());
  const auto text = chart_text({one}, 10, 3);
  EXPECT_THAT(text, HasSubstr("\n1.798e+308 |         *\n"));
  EXPECT_THAT(text, HasSubstr("\n-1.23e-300 |*\n"));
  EXPECT_THAT(svg_of(chart_drawing({one})),
              testing::AllOf(HasSubstr(">1.8e+308</text>"), HasSubstr(">-1.2e-300</text>")));
}

TEST(StateBars, TellWhichTextWasSo) {
  StateBars bars;
  for (int i = 2; i < 8; ++i) bars.add(i, i < 5 ? "wander" : "stuck");
  const auto columns = bars.columns(0, 10, 10);
  EXPECT_EQ(columns[1], std::nullopt);
  EXPECT_EQ(columns[2], 0U);
  EXPECT_EQ(columns[4], 0U);
  EXPECT_EQ(columns[5], 1U);
  EXPECT_EQ(columns[7], 1U);
  EXPECT_EQ(columns[8], std::nullopt);
  EXPECT_EQ(bars.names(), (std::vector<std::string>{"wander", "stuck"}));
}

TEST(StateBars, AreBoundedHoweverManyTextsCome) {
  StateBars bars;
  for (int i = 0; i < 200'000; ++i) bars.add(i, std::to_string(i % 1000));
  EXPECT_EQ(bars.names().size(), StateBars::kMostNames + 1);
  EXPECT_EQ(bars.names().back(), StateBars::kOthers);
  EXPECT_EQ(bars.columns(0, 200'000, 100).size(), 100U);
}

TEST(Chart, DrawsTextsAsBars) {
  NamedBars state{"io/state.state", {}};
  for (int i = 0; i < 10; ++i) state.bars.add(i, i < 5 ? "wander" : "stuck");
  EXPECT_EQ(chart_text({}, 10, 4, {state}),
            "io/state.state: A wander, B stuck\n"
            "     state |AAAAABBBBB\n"
            "           +----------\n"
            "            0 s    9 s\n");
}

class PlotTest : public LoggedTeam {
 protected:
  PlotTest() { write("run.mcap", six_seconds()); }
  Answer plotted(PlotOptions options) {
    options.file = path("run.mcap");
    return answer_of([&] { return plot(options); });
  }
};

TEST_F(PlotTest, DrawsFieldsOfTopics) {
  const auto answer = plotted({.values = {"io/state.x_m", "/io/state.tick"}});
  EXPECT_EQ(answer.code, 0) << answer.errors;
  EXPECT_THAT(answer.out, HasSubstr("a io/state.x_m: 0 to 5.9\nb /io/state.tick: 0 to 59\n"));
}

TEST_F(PlotTest, DrawsStatesBelowNumbers) {
  const auto answer = plotted({.values = {"io/state.x_m", "io/state.state"}});
  EXPECT_EQ(answer.code, 0) << answer.errors;
  EXPECT_THAT(answer.out,
              HasSubstr("* io/state.x_m: 0 to 5.9\nio/state.state: A wander, B stuck\n"));
  EXPECT_THAT(answer.out, HasSubstr("\n     state |AAAA"));
  EXPECT_EQ(plotted({.values = {"io/state.state"}, .pictures = {.svg = path("s.svg")}}).code, 0);
  const auto bytes = read("s.svg");
  EXPECT_THAT(std::string(bytes.begin(), bytes.end()), HasSubstr(">wander</text>"));
}

TEST_F(PlotTest, WritesAPictureOnce) {
  const PlotOptions options{.values = {"io/state.x_m"}, .pictures = {.svg = path("x.svg")}};
  EXPECT_EQ(plotted(options).code, 0);
  const auto bytes = read("x.svg");
  EXPECT_THAT(std::string(bytes.begin(), bytes.end()),
              testing::AllOf(testing::StartsWith("<svg xmlns="), HasSubstr("<polyline"),
                             testing::EndsWith("</svg>\n")));
  EXPECT_THAT(plotted(options).errors, HasSubstr("exists already"));
}

TEST_F(PlotTest, NeverWritesOverTheRecordingNorOnePictureOverTheOther) {
  const auto before = read("run.mcap");
  std::filesystem::create_hard_link(path("run.mcap"), path("twin.mcap"));
  for (const auto& pictures : {PictureFiles{.svg = path("run.mcap"), .png = {}, .replace = true},
                               PictureFiles{.svg = {}, .png = path("run.mcap"), .replace = true},
                               PictureFiles{.svg = path("twin.mcap"), .png = {}, .replace = true}})
    for (const bool map : {false, true}) {
      PlotOptions options{.pictures = pictures};
      if (!map) options.values = {"io/state.x_m"};
      options.map = map;
      const auto answer = plotted(options);
      EXPECT_EQ(answer.code, 1);
      EXPECT_THAT(answer.errors, HasSubstr("is read here and cannot be written"));
    }
  EXPECT_EQ(read("run.mcap"), before);
  EXPECT_THAT(plotted({.values = {"io/state.x_m"},
                       .pictures = {.svg = path("x"), .png = path("./x"), .replace = true}})
                  .errors,
              HasSubstr("would be written twice"));
}

TEST_F(PlotTest, WritesAPngOfTheSamePicture) {
  const PlotOptions options{.values = {"io/state.x_m", "io/state.state"},
                            .pictures = {.png = path("x.png")}};
  const auto answer = plotted(options);
  EXPECT_EQ(answer.code, 0) << answer.errors;
  const auto bytes = read("x.png");
  ASSERT_GT(bytes.size(), 24U);
  EXPECT_EQ(std::string(bytes.begin() + 1, bytes.begin() + 4), "PNG");
  const auto size_at = [&](std::size_t at) { return bytes[at + 2] << 8 | bytes[at + 3]; };
  EXPECT_EQ(size_at(16), 960);       // width
  EXPECT_EQ(size_at(20), 360 + 44);  // height, with a bar
}

TEST_F(PlotTest, APictureThatTheDiskDoesNotTakeIsNotLeftThere) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit none{0, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &none);
  const auto done = write_pictures({.svg = path("x.svg"), .png = {}}, {10, 20, {}});
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_FALSE(done);
  EXPECT_FALSE(std::filesystem::exists(path("x.svg")));
}

TEST(Svg, TakesNoTextForItsOwn) {
  const auto svg =
      svg_of({10, 20, {Label{.x = 1, .y = 2, .text = "<a>&\x1b", .colour = "#ff0000"}}});
  EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 10 20\""));
  EXPECT_THAT(svg, HasSubstr(">&lt;a>&amp;U+001B</text>"));
}

TEST_F(PlotTest, SaysWhatCannotBeDrawn) {
  EXPECT_THAT(plotted({.values = {"io/state.problems"}}).errors,
              HasSubstr("there is no number and no text of"));
  EXPECT_THAT(plotted({.values = {"io/state"}}).errors, HasSubstr("is no TOPIC.FIELD"));
  EXPECT_THAT(plotted({.values = {"io/stat.x_m"}}).errors, HasSubstr("did you mean '/io/state'?"));
  EXPECT_THAT(plotted({.values = {"io/state.y"}}).errors, HasSubstr("has no field 'y'"));
  EXPECT_THAT(plotted({.values = {"io/state.x_m"}, .from_s = 60}).errors,
              HasSubstr("there is no message of io/state from 60 s on; "));
}

}  // namespace
}  // namespace galilean::logs
