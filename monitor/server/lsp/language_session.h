// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <filesystem>

#include "core/catalog/catalog.h"
#include "monitor/background/worker.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// What the language server needs of the monitor. Texts are read and checked on `worker`, which is
/// theirs alone, so that nobody's typing keeps a push or the page waiting.
struct LanguageDesk {
  Worker& worker;
  const Team& team;
  const Catalog& installed;              ///< for programs while no robot has published its own
  std::filesystem::path library_folder;  ///< what a client calls file:/// and includes from
};

/// Serves the language server over one WebSocket until it closes, a JSON-RPC message a text frame.
/// Programs are checked against the catalog of the robot that the query names (`?robot=io`), else
/// of the first that has one. The session keeps itself.
void serve_language(boost::asio::ip::tcp::socket socket,
                    const boost::beast::http::request<boost::beast::http::string_body>& upgrade,
                    LanguageDesk& desk);

}  // namespace galilean::monitor
