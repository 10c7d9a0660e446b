// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/websocket/batching_socket.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

#include "monitor/server/websocket/frame.h"

namespace galilean::monitor {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

/// A connection's two ends.
struct Connection {
  explicit Connection(asio::io_context& io) : here(io), there(io) {
    tcp::acceptor acceptor(io, {asio::ip::address_v4::loopback(), 0});
    there.connect(acceptor.local_endpoint());
    here = acceptor.accept();
  }
  tcp::socket here, there;
};

TEST(BatchingSocketTest, ItsOutboxMayGoBeforeTheRoundThatWasToSendIt) {
  asio::io_context io{1};
  SendRounds rounds(io);
  Connection connection(io);
  BatchingSocket socket(std::move(connection.here), rounds);
  auto outbox = std::make_shared<Outbox>();
  socket.send_from(outbox);
  ASSERT_TRUE(outbox->push(text_frame("never sent")));
  socket.flush();
  outbox.reset();
  io.run();
  EXPECT_EQ(connection.there.available(), 0U);
  socket.close();
  char byte = 0;
  boost::system::error_code error;
  (void)connection.there.read_some(asio::buffer(&byte, 1), error);
  EXPECT_EQ(error, asio::error::eof);
}

/// Counts how often it sends, and joins the next round when it is told to.
struct CountingSender final : SendRounds::Sender {
  void send_waiting() override { ++*sent; }
  explicit CountingSender(int& count) : sent(&count) {}
  int* sent;
};

TEST(SendRoundsTest, EachIsSentToOnceAndOthersHaveTheirTurnInBetween) {
  asio::io_context io{1};
  SendRounds rounds(io);
  int sent = 0, sent_at_others_turn = -1;
  std::vector<std::shared_ptr<CountingSender>> senders;
  for (std::size_t i = 0; i < 4 * SendRounds::kAtOnce; ++i)
    senders.push_back(std::make_shared<CountingSender>(sent));
  for (const auto& sender : senders) rounds.add(sender);
  for (const auto& sender : senders) rounds.add(sender);  // is in the round already
  while (sent == 0) io.run_one();
  EXPECT_EQ(sent, static_cast<int>(SendRounds::kAtOnce));
  asio::post(io, [&] { sent_at_others_turn = sent; });
  rounds.add(senders.front());  // was sent to, and comes again in the next round
  io.run();
  EXPECT_LT(sent_at_others_turn, static_cast<int>(senders.size()));
  EXPECT_EQ(sent, static_cast<int>(senders.size()) + 1);
}

/// A socket whose client does not read yet, and that was asked to write more than the kernel holds.
class HeldUp : public testing::Test {
 protected:
  HeldUp() {
    asio::async_write(socket, asio::buffer(much),
                      [this](boost::system::error_code error, std::size_t) { written = error; });
    io.poll();
  }

  const std::string much = std::string(32 << 20, 'x');
  asio::io_context io{1};
  SendRounds rounds{io};
  Connection connection{io};
  BatchingSocket socket{std::move(connection.here), rounds};
  std::optional<boost::system::error_code> written;
};

TEST_F(HeldUp, AWriteIsDoneWhenItHasLeft) {
  ASSERT_FALSE(written);
  std::string received(much.size(), ' ');
  asio::async_read(connection.there, asio::buffer(received), [](auto, auto) {});
  io.restart();
  io.run();
  EXPECT_EQ(written, boost::system::error_code());
  EXPECT_EQ(received, much);
}

TEST_F(HeldUp, AWriteFailsWhenTheConnectionIsClosed) {
  std::optional<boost::system::error_code> behind;
  asio::async_write(socket, asio::buffer(much, 1), [&](auto error, auto) { behind = error; });
  socket.close();
  EXPECT_FALSE(written);
  io.restart();
  io.run();
  EXPECT_EQ(written, asio::error::operation_aborted);
  ASSERT_TRUE(behind);
  EXPECT_TRUE(*behind);
}

TEST_F(HeldUp, AWriteAfterTheEndFails) {
  socket.close();
  written.reset();
  std::optional<boost::system::error_code> after;
  asio::async_write(socket, asio::buffer(much, 1), [&](auto error, auto) { after = error; });
  io.restart();
  io.run();
  EXPECT_EQ(after, asio::error::connection_aborted);
}

}  // namespace
}  // namespace galilean::monitor
