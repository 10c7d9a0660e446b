// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <cstddef>
#include <filesystem>
#include <memory>

#include "core/catalog/catalog.h"
#include "monitor/background/worker.h"
#include "monitor/server/websocket/revocable.h"
#include "monitor/server/websocket/web_socket.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// The parts of the monitor that the language server uses. Programs are read and checked on
/// `worker`, which does nothing else, so that typing delays neither a push nor the page.
struct LanguageServerContext {
  Worker& worker;
  const Team& team;
  const Catalog& installed;              ///< the catalog while no robot has published one
  std::filesystem::path library_folder;  ///< a client's file:///, where its includes are found
  /// How many sessions there are. They may outlive this.
  std::shared_ptr<std::size_t> sessions = std::make_shared<std::size_t>(0);
};

/// An editor keeps its texts open here, so no more of them are served at once.
inline constexpr std::size_t kMostLanguageSessions = 32;

/// Serves the language server over one WebSocket until it closes. Each text message is one JSON-RPC
/// message. Programs are checked against the catalog of the robot that the query names
/// (`?robot=io`), else against that of the first robot that is not silent and has published one.
/// Beyond kMostLanguageSessions the WebSocket closes with the reason.
/// The session, which is returned, owns itself until then. `rounds` and `context` must outlive it.
std::weak_ptr<Revocable> serve_language(boost::asio::ip::tcp::socket socket,
                                        const WebSocket::Upgrade& upgrade, SendRounds& rounds,
                                        LanguageServerContext& context,
                                        std::shared_ptr<Connections::Place> place = nullptr);

}  // namespace galilean::monitor
