// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/coverage_desk.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/json_text.h"
#include "tests/monitor/coverage/fetch_program.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class CoverageDeskTest : public testing::Test {
 protected:
  ~CoverageDeskTest() override { worker_.finish(); }

  void write(const std::string& name, const mcap::Bytes& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  void ask(const std::string& name) {
    desk_.ask(name, [this](HttpResponse response) { answers_.push_back(std::move(response)); });
  }
  /// Waits until so many answers have come in all.
  void wait_for(std::size_t answers) {
    while (answers_.size() < answers) io_.run_one();
  }
  HttpResponse answer_about(const std::string& name) {
    ask(name);
    wait_for(answers_.size() + 1);
    return answers_.back();
  }
  static nlohmann::json json_of(const HttpResponse& response) {
    return read_json(*response.body).value();
  }

  TemporaryFolder folder_;
  RecordingFolder recordings_{folder_.path()};
  boost::asio::io_context io_;
  const boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_ =
      boost::asio::make_work_guard(io_);  ///< without which it would stop at the first wait's end
  Worker worker_{io_};
  CoverageDesk desk_{recordings_, worker_};
  std::vector<HttpResponse> answers_;
};

TEST_F(CoverageDeskTest, TellsWhatTheWholeRecordingExercised) {
  write("run.mcap", recording_of_fetch());
  const auto answer = answer_about("run.mcap");
  ASSERT_EQ(answer.status, 200) << *answer.body;
  const auto told = json_of(answer);
  EXPECT_EQ(told["name"], "run.mcap");
  EXPECT_THAT(told["uncounted"], IsEmpty());
  ASSERT_EQ(told["programs"].size(), 1U);
  const auto& program = told["programs"][0];
  EXPECT_EQ(program["hash"], "3f2a");
  EXPECT_EQ(program["states"][1]["entered"], 1);
  EXPECT_EQ(program["states"][2]["visited"], false);
  EXPECT_EQ(program["conditions"][0]["taken"], 1);
  EXPECT_EQ(program["conditions"][1]["held_behind_another"], 1);
}

TEST_F(CoverageDeskTest, CountsOnceForAllWhoAskMeanwhile) {
  write("run.mcap", recording_of_fetch());
  for (int i = 0; i < 3; ++i) ask("run.mcap");
  wait_for(3);
  EXPECT_EQ(answers_[0].body, answers_[2].body);  // the same, and not only alike
  EXPECT_EQ(answer_about("run.mcap").body, answers_[0].body);
}

TEST_F(CoverageDeskTest, CountsAnewWhatIsAnotherFileByNow) {
  write("run.mcap", recording_of_fetch());
  EXPECT_EQ(json_of(answer_about("run.mcap"))["programs"].size(), 1U);
  write("run.mcap", expect::RecordedTeam().end());
  EXPECT_EQ(json_of(answer_about("run.mcap"))["programs"].size(), 0U);
}

TEST_F(CoverageDeskTest, SaysWhatIsMissing) {
  auto bytes = recording_of_fetch();
  expect::damage_chunk_at(0, bytes);
  write("damaged.mcap", bytes);
  const auto told = json_of(answer_about("damaged.mcap"));
  EXPECT_THAT(told["uncounted"].get<std::vector<std::string>>(), Contains(HasSubstr("lost")));
  bytes = recording_of_fetch();
  bytes.resize(bytes.size() - 8);
  write("cut.mcap", bytes);
  EXPECT_THAT(json_of(answer_about("cut.mcap"))["uncounted"].get<std::vector<std::string>>(),
              Contains(HasSubstr("not closed properly")));
}

TEST_F(CoverageDeskTest, RefusesWhatIsNoRecording) {
  EXPECT_EQ(answer_about("gone.mcap").status, 404);
  EXPECT_EQ(answer_about("../run.mcap").status, 404);
  write("notes.mcap", {'n', 'o'});
  const auto answer = answer_about("notes.mcap");
  EXPECT_EQ(answer.status, 422);
  EXPECT_THAT(*answer.body, HasSubstr("'notes.mcap'"));
}

TEST_F(CoverageDeskTest, EndsWhenTheMonitorEnds) {
  write("run.mcap", recording_of_fetch());
  desk_.stop();
  EXPECT_EQ(answer_about("run.mcap").status, 503);
}

}  // namespace
}  // namespace galilean::monitor
