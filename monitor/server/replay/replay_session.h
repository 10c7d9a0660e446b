// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "monitor/recordings/recording_folder.h"
#include "monitor/server/replay/playbacks.h"
#include "monitor/server/websocket/revocable.h"
#include "monitor/server/websocket/web_socket.h"

namespace galilean::monitor {

/// The parts of the monitor that replays use.
struct ReplayContext {
  const RecordingFolder& folder;
  Playbacks& playbacks;
};

/// Plays the recording that the query names (`?recording=office.mcap&at=90`) over one WebSocket,
/// until it closes. The session, which is returned, owns itself until then. `rounds` and `context`
/// must outlive it.
std::weak_ptr<Revocable> serve_replay(boost::asio::ip::tcp::socket socket,
                                      const WebSocket::Upgrade& upgrade, SendRounds& rounds,
                                      ReplayContext& context,
                                      std::shared_ptr<Connections::Place> place = nullptr);

}  // namespace galilean::monitor
