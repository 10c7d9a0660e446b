// SPDX-License-Identifier: BSD-3-Clause
#include "sim/telemetry/order_desk.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "tests/free_domain.h"

namespace galilean::sim {
namespace {

using namespace std::chrono_literals;

/// A desk whose world never takes an order, and an instructor in another participant.
class OrderDeskTest : public testing::Test {
 protected:
  /// Sends the order, and others like it with the next ids, until one is refused, for ten seconds
  /// at most. Returns the refusal's text.
  std::string refusal_of(msg::SimulationOrder order) {
    std::string text;
    for (int i = 0; i < 5000 && text.empty(); ++i) {
      if (!order.id.empty()) order.id = std::to_string(++sent_);
      EXPECT_TRUE(orders_.write(order));
      std::this_thread::sleep_for(2ms);
      events_.take([&](const wire::Received& received) {
        msg::SimulationEvent event;
        if (msg::decode_cdr(received.cdr, event) && !event.done) text = event.text;
      });
    }
    return text;
  }

  const int domain_ = free_domain();
  std::unique_ptr<wire::Participant> own_ = wire::Participant::join("sim", domain_).value();
  std::unique_ptr<wire::Participant> other_ = wire::Participant::join("teacher", domain_).value();
  OrderDesk desk_{*own_, "office"};
  wire::Writer<msg::SimulationOrder> orders_{*other_, wire::kSimulationOrderTopic};
  wire::Reader events_{*other_, wire::kSimulationEventTopic, msg::SimulationEvent::kRosType};
  int sent_ = 0;
};

TEST_F(OrderDeskTest, AnOrderWithoutAnIdIsRefused) {
  msg::SimulationOrder order;
  order.simulation = "office";
  EXPECT_EQ(refusal_of(order), "it has no id");
  EXPECT_TRUE(desk_.take().empty());
}

TEST_F(OrderDeskTest, AFloodIsRefusedAndDoesNotGrow) {
  msg::SimulationOrder order;
  order.simulation = "office";
  order.id = "1";
  EXPECT_EQ(refusal_of(order), "too many orders wait");
  EXPECT_EQ(desk_.take().size(), 256U);
}

}  // namespace
}  // namespace galilean::sim
