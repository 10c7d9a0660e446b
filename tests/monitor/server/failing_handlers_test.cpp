// SPDX-License-Identifier: BSD-3-Clause
// Faults of our own: what a handler throws ends in an answer or a closed connection, and the others
// are served on.
#include <gmock/gmock.h>

#include <array>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>
#include <future>
#include <new>
#include <stdexcept>
#include <thread>

#include "monitor/background/worker.h"
#include "monitor/server/http/http_server.h"

namespace galilean::monitor {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using nlohmann::json;
using testing::HasSubstr;

TEST(FailingJob, WhatItThrowsGoesToWhoWaitsOnTheOwnersThread) {
  asio::io_context io{1};
  Worker worker(io);
  std::vector<std::string> told;
  const auto tell = [&](const std::string& text) { told.push_back(text); };
  const auto tell_number = [&](int number) { tell(std::to_string(number)); };
  worker.run([]() -> int { throw std::runtime_error("the disk is full"); }, tell_number, tell);
  worker.run([] { return 3; }, tell_number, tell);
  worker.run([] { return 4; }, [](int) { throw std::runtime_error("no"); }, tell);
  worker.run([] { throw std::runtime_error("nobody waits"); });
  worker.run([] { return 5; }, tell_number, [](const std::string&) {});
  worker.finish();
  EXPECT_TRUE(told.empty()) << "nothing is told on the worker's thread";
  io.run();
  EXPECT_EQ(told, (std::vector<std::string>{"the disk is full", "3", "no", "5"}));
}

/// Tells which thread destroys it.
class Session {
 public:
  explicit Session(std::thread::id& destroyed_on) : destroyed_on_(destroyed_on) {}
  ~Session() { destroyed_on_ = std::this_thread::get_id(); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

 private:
  std::thread::id& destroyed_on_;
};

TEST(FailingJob, ItsSessionIsFreedOnTheOwnersThread) {
  asio::io_context io{1};
  Worker worker(io);
  int answers = 0;
  std::array<std::thread::id, 3> destroyed_on;
  const auto tell = [&](const std::string&) { ++answers; };
  {
    // What is captured from a constant is constant, so that moving the job copies it.
    const auto first = std::make_shared<Session>(destroyed_on[0]);
    const auto second = std::make_shared<Session>(destroyed_on[1]);
    const auto third = std::make_shared<Session>(destroyed_on[2]);
    worker.run([first]() -> int { throw std::runtime_error("no"); }, [](int) {}, tell);
    worker.run([] { return 1; }, [second, &answers](int) { ++answers; }, tell);
    worker.run([third] { throw std::runtime_error("nobody waits"); });
  }
  worker.finish();
  io.run();
  EXPECT_EQ(answers, 2);
  for (const auto& thread : destroyed_on) EXPECT_EQ(thread, std::this_thread::get_id());
}

TEST(FailingJob, WhateverItThrowsIsAnswered) {
  asio::io_context io{1};
  Worker worker(io);
  std::vector<std::string> told;
  const auto tell = [&](const std::string& text) { told.push_back(text); };
  worker.run([]() -> int { throw 3; }, [](int) {}, tell);
  worker.run([]() -> int { throw std::bad_alloc(); }, [](int) {}, tell);
  worker.finish();
  io.run();
  EXPECT_EQ(told, (std::vector<std::string>{"an unknown fault", "out of memory"}));
  EXPECT_GE(memory_failures.load(), 1U);
}

TEST(BoundedWorker, RefusesWhatIsMoreThanMayWait) {
  asio::io_context io{1};
  Worker worker(io, 1, 2);
  std::promise<void> may_end, has_begun;
  int done = 0;
  const auto count = [&](int) { ++done; };
  const auto fail = [](const std::string&) {};
  ASSERT_TRUE(worker.offer(
      [&] {
        has_begun.set_value();
        may_end.get_future().wait();
        return 0;
      },
      count, fail));
  has_begun.get_future().wait();
  EXPECT_TRUE(worker.offer([] { return 1; }, count, fail));
  EXPECT_TRUE(worker.offer([] { return 2; }, count, fail));
  EXPECT_EQ(worker.waiting(), 2U);
  EXPECT_FALSE(worker.offer([] { return 3; }, count, fail));
  worker.run([] { return 4; }, count, fail);  // the monitor's own jobs are always taken
  may_end.set_value();
  worker.finish();
  io.run();
  EXPECT_EQ(done, 4);
}

TEST(WorkersOrder, WhatIsFirstPassesByWhatWaits) {
  asio::io_context io{1};
  Worker worker(io);
  std::promise<void> may_end, has_begun;
  std::vector<int> begun;
  const auto number = [&begun](int which) {
    return [&begun, which] {
      begun.push_back(which);
      return which;
    };
  };
  const auto nothing = [](const auto&) {};
  worker.run([&] {
    has_begun.set_value();
    may_end.get_future().wait();
  });
  has_begun.get_future().wait();
  worker.run(number(1), nothing, nothing);
  worker.run(number(2), nothing, nothing);
  worker.run_first(number(3), nothing, nothing);
  worker.run_first(number(4), nothing, nothing);
  EXPECT_EQ(worker.waiting(), 4U);
  may_end.set_value();
  worker.finish();
  EXPECT_EQ(begun, (std::vector<int>{3, 4, 1, 2}));
}

TEST(BoundedWorker, DropsWhatHasNotBegunWhereItIsToldTo) {
  asio::io_context io{1};
  std::thread::id destroyed_on;
  bool has_run = false;
  {
    Worker worker(io);
    std::promise<void> has_begun, may_end;
    worker.run([&] {
      has_begun.set_value();
      may_end.get_future().wait();
    });
    has_begun.get_future().wait();
    worker.run([session = std::make_shared<Session>(destroyed_on), &has_run] { has_run = true; });
    worker.drop_waiting();
    may_end.set_value();
    worker.finish();
  }
  EXPECT_FALSE(has_run);
  EXPECT_EQ(destroyed_on, std::this_thread::get_id());
}

class Link final : public foxglove::Link {
 public:
  void flush() override {}
  void close(const std::string&) override {}
};

/// The messages that wait for a client.
std::vector<json> texts(foxglove::Hub::Client& client) {
  std::vector<json> list;
  for (const auto& frame : client.outbox().take(1000))
    list.push_back(json::parse(frame.payload->begin(), frame.payload->end(), nullptr, false));
  return list;
}

TEST(FailingService, FailsTheCallAndNotTheClient) {
  foxglove::Hub hub("monitor", [](std::uint32_t, bool) {});
  hub.add_service({"/early", "t/T", json::object(), json::object()},
                  [](const json&, const foxglove::Hub::Answer&) { throw std::runtime_error("a"); });
  hub.add_service({"/late", "t/T", json::object(), json::object()},
                  [](const json&, const foxglove::Hub::Answer& answer) {
                    answer(Error{"refused"});
                    throw std::runtime_error("b");
                  });
  hub.on_set_parameter([](const foxglove::Parameter&, const foxglove::Hub::Answer&) {
    throw std::runtime_error("c");
  });
  hub.send_parameters({{"/io.held", false}});
  Link link;
  const auto client = hub.connect(link, true);
  (void)texts(*client);
  const auto call = [&](std::uint8_t service) {
    const std::vector<std::uint8_t> bytes{2, service, 0, 0, 0,   7,   0,   0,   0,
                                          4, 0,       0, 0, 'j', 's', 'o', 'n', '3'};
    client->receive_binary(bytes);
    return texts(*client);
  };
  const auto early = call(1), late = call(2);
  ASSERT_EQ(early.size(), 2U);
  EXPECT_EQ(early[0]["op"], "serviceCallFailure");
  EXPECT_EQ(early[0]["message"], "The monitor cannot do this now: a.");
  ASSERT_EQ(late.size(), 2U) << "one answer a call";
  EXPECT_EQ(late[0]["message"], "refused");
  client->receive_text(R"({"op":"setParameters","parameters":[{"name":"/io.held","value":true}]})");
  EXPECT_THAT(texts(*client).at(0)["message"].get<std::string>(), HasSubstr("c"));
}

/// A server whose handler does what `handler` says, and a connection to it.
class FailingHttpHandler : public testing::Test {
 protected:
  void SetUp() override {
    const auto listening = server.listen("127.0.0.1", 0);
    ASSERT_TRUE(listening);
    socket.connect({asio::ip::address_v4::loopback(), listening.value()});
    thread = std::thread([this] { io.run(); });
  }
  void TearDown() override {
    io.stop();
    thread.join();
  }
  /// The answer's head and body.
  std::string ask() {
    asio::write(socket, asio::buffer(std::string("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")));
    std::string answer;
    const auto head = asio::read_until(socket, asio::dynamic_buffer(answer), "\r\n\r\n");
    const auto length = answer.find("Content-Length: ");
    const auto body = std::stoul(answer.substr(length + 16));
    if (answer.size() < head + body)
      asio::read(socket, asio::dynamic_buffer(answer),
                 asio::transfer_exactly(head + body - answer.size()));
    return answer;
  }

  HttpHandler handler;
  SteadyClock clock;
  Team team{clock};
  const Catalog catalog{};
  foxglove::Hub hub{"monitor", [](std::uint32_t, bool) {}};
  asio::io_context io{1};
  SendRounds rounds{io};
  Worker worker{io};
  LanguageServerContext language{worker, team, catalog, {}};
  RecordingFolder recordings{testing::TempDir()};
  Playbacks playbacks;
  ReplayContext replay{recordings, playbacks};
  HttpServer server{
      io,
      {Guard("127.0.0.1", {}), Access({"viewer", "operator"}, true),
       [this](const HttpRequest& request, const Respond& respond) { handler(request, respond); },
       hub, rounds, language, replay, worker}};
  std::thread thread;
  asio::io_context mine;
  tcp::socket socket{mine};
};

TEST_F(FailingHttpHandler, IsAnsweredOnceWith500AndTheConnectionServesOn) {
  int requests = 0;
  Respond kept;
  handler = [&](const HttpRequest&, const Respond& respond) {
    switch (++requests) {
      case 1:
        kept = respond;
        throw std::runtime_error("out of order");
      case 2:
        kept(text_response("an answer to the first", "text/plain"));
        respond(text_response("second", "text/plain"));
        throw std::runtime_error("too late");
      default:
        respond(text_response("third", "text/plain"));
    }
  };
  const auto first = ask();
  EXPECT_THAT(first, HasSubstr("HTTP/1.1 500 "));
  EXPECT_THAT(first, HasSubstr("out of order"));
  EXPECT_THAT(ask(), testing::EndsWith("\r\n\r\nsecond"));
  EXPECT_THAT(ask(), testing::EndsWith("\r\n\r\nthird"));
}

}  // namespace
}  // namespace galilean::monitor
