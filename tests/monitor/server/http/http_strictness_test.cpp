// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/http_strictness.h"

#include <gmock/gmock.h>

#include <boost/asio/buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>

namespace galilean::monitor {
namespace {

namespace http = boost::beast::http;

/// Returns the status with which a head is refused, 0 if it is not. `fields` follow the first line.
int refused_with(const std::string& fields, const std::string& version = "1.1") {
  const std::string head = "POST /api/command HTTP/" + version + "\r\n" + fields + "\r\n";
  EXPECT_EQ(head_size(head + "body"), head.size());
  if (const auto malformed = malformed_lines(head)) return malformed->status;
  http::request_parser<http::empty_body> parser;
  boost::system::error_code error;
  parser.put(boost::asio::buffer(head), error);
  if (error && error != http::error::need_more) return 400;
  if (!parser.is_header_done()) return 400;
  const auto malformed = malformed_fields(parser.get().base(), 10);
  return malformed ? malformed->status : 0;
}

TEST(HttpStrictness, WhatIsHttpPasses) {
  EXPECT_EQ(refused_with("Host: localhost\r\n"), 0);
  EXPECT_EQ(refused_with("Host:localhost:8080\r\nContent-Length: 4\r\n"), 0);
  EXPECT_EQ(refused_with("Host: localhost\r\nTransfer-Encoding: chunked\r\n"), 0);
  EXPECT_EQ(refused_with("Host: localhost\r\nTransfer-Encoding: Chunked\r\n"), 0);
  EXPECT_EQ(refused_with("", "1.0"), 0);
}

TEST(HttpStrictness, ThereIsOneHost) {
  EXPECT_EQ(refused_with(""), 400);
  EXPECT_EQ(refused_with("Host: localhost\r\nHost: localhost\r\n"), 400);
  EXPECT_EQ(refused_with("Host: localhost\r\nhost: evil.example\r\n"), 400);
  EXPECT_EQ(refused_with("Host: a\r\nHost: b\r\n", "1.0"), 400);
}

TEST(HttpStrictness, ABodyHasOneLengthThatEverybodyReadsAlike) {
  const std::string host = "Host: localhost\r\n";
  for (const auto* coding : {"xchunked", "gzip", "gzip, chunked", "chunked, gzip", "identity",
                             "\x0b"
                             "chunked",
                             "chunked;a=b", ""})
    EXPECT_GE(refused_with(host + "Transfer-Encoding: " + coding + "\r\n"), 400) << coding;
  EXPECT_EQ(refused_with(host + "Transfer-Encoding: xchunked\r\n"), 501);
  EXPECT_GE(refused_with(host + "Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n"),
            400);
  EXPECT_EQ(refused_with(host + "Transfer-Encoding: chunked\r\nContent-Length: 4\r\n"), 400);
  EXPECT_EQ(refused_with(host + "Content-Length: 4\r\nTransfer-Encoding: chunked\r\n"), 400);
  EXPECT_EQ(refused_with(host + "Content-Length: 4\r\nContent-Length: 5\r\n"), 400);
  EXPECT_EQ(refused_with(host + "Content-Length: +4\r\n"), 400);
  EXPECT_EQ(refused_with(host + "Transfer-Encoding: chunked\r\n", "1.0"), 400);
}

TEST(HttpStrictness, AFieldStandsOnOneLineThatEndsWithCrLf) {
  EXPECT_EQ(refused_with("Host: localhost\r\nX: a\r\n b\r\n"), 400);
  EXPECT_EQ(refused_with("Host: localhost\r\nX: a\r\n\tb\r\n"), 400);
  EXPECT_EQ(refused_with("Host: localhost\r\n Host: evil.example\r\n"), 400);
  EXPECT_EQ(refused_with("Host: localhost\r\nX : a\r\n"), 400);
  for (const std::string head :
       {"GET / HTTP/1.1\nHost: localhost\n\n", "GET / HTTP/1.1\r\nHost: a\nX: b\r\n\r\n", "\n"}) {
    const auto size = head_size(head);
    ASSERT_TRUE(size);
    EXPECT_TRUE(malformed_lines(std::string_view(head).substr(0, *size))) << head;
  }
  EXPECT_TRUE(malformed_lines("GET / HTTP/1.1\r\nX: a\rb\r\n\r\n"));
  EXPECT_TRUE(malformed_lines(std::string("GET / HTTP/1.1\r\nX: a\0b\r\n\r\n", 26)));
}

TEST(HttpStrictness, FieldsAreCounted) {
  std::string fields = "Host: localhost\r\n";
  for (int i = 0; i < 9; ++i) fields += "X: a\r\n";
  EXPECT_EQ(refused_with(fields), 0);
  EXPECT_EQ(refused_with(fields + "X: a\r\n"), 431);
}

TEST(HttpStrictness, AHeadThatHasNotComeHasNoSize) {
  const std::string head = "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n";
  for (std::size_t size = 0; size < head.size(); ++size)
    EXPECT_FALSE(head_size(head.substr(0, size))) << size;
  EXPECT_EQ(head_size(head + head), head.size());
}

}  // namespace
}  // namespace galilean::monitor
