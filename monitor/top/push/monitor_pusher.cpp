// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/push/monitor_pusher.h"

#include "monitor/commands/push_session.h"

namespace galilean::monitor::top {
namespace {

/// The longest time that quitting waits for a request that is under way.
constexpr std::chrono::milliseconds kMostAtEnd{100};

/// Returns the way to the monitor that `options` names.
AskMonitor over_http(const PushOptions& options) {
  return [url = options.monitor, token_file = options.token_file, trust = options.trust](
             const std::string& path,
             const std::optional<nlohmann::json>& body) -> Result<MonitorAnswer, Unanswered> {
    const auto monitor = MonitorClient::at(url, token_file, trust);
    if (!monitor) return Unanswered{{monitor.error().message}};
    return body ? monitor.value().post(path, *body) : monitor.value().get(path);
  };
}

}  // namespace

MonitorPusher::MonitorPusher(PushOptions options)
    : MonitorPusher(options, over_http(options), kAskAgainFor) {}

MonitorPusher::MonitorPusher(PushOptions options, AskMonitor ask, Duration ask_again_for)
    : worker_(std::make_shared<PushWorker>(std::move(options), std::move(ask), ask_again_for)),
      thread_([worker = worker_] { worker->run(); }) {}

MonitorPusher::~MonitorPusher() {
  worker_->end();
  if (worker_->wait_for_end(kMostAtEnd))
    thread_.join();
  else
    thread_.detach();
}

}  // namespace galilean::monitor::top
