// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/commands/monitor_client.h"
#include "monitor/front/doctor/intake_check.h"

namespace galilean::front {

Check check_messages(int port) {
  const std::string what = "messages";
  const auto client = monitor::MonitorClient::at("http://127.0.0.1:" + std::to_string(port), {});
  if (!client) return {what, true, "no monitor can be asked: " + client.error().message};
  const auto answer = client.value().get("/api/status");
  if (!answer)
    return {what, true,
            "no monitor answers on port " + std::to_string(port) +
                ", which would say what it did not take"};
  if (!answer.value().ok())
    return {what, true,
            "the monitor does not say what it did not take: " + answer.value().detail()};
  return intake_check(answer.value().json);
}

}  // namespace galilean::front
