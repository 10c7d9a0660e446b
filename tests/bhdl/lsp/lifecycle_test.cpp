// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "bhdl/lsp/features/document_sync.h"
#include "bhdl/lsp/protocol/framing.h"
#include "tests/bhdl/lsp/editor.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl::lsp {
namespace {

int error_code(Server& server, const std::string& message) {
  const auto answers = server.receive(message);
  if (answers.size() != 1) return 0;
  return Json::parse(answers.front())["error"].value("code", 0);
}

Server fresh_server() {
  return Server(small_catalog(),
                std::make_unique<MemoryFolder>(std::map<std::string, std::string>{}));
}

std::string did_open_message(const std::string& uri, const std::string& text) {
  const Json document{{"uri", uri}, {"languageId", "bhdl"}, {"version", 1}, {"text", text}};
  return Json{{"jsonrpc", "2.0"},
              {"method", "textDocument/didOpen"},
              {"params", {{"textDocument", document}}}}
      .dump();
}

TEST(Lifecycle, WhatIsNoMessageIsToldSoWithTheRightCode) {
  Server server = fresh_server();
  const std::string deep = R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":)" +
                           std::string(1'000'000, '[') + std::string(1'000'000, ']') + "}";
  EXPECT_EQ(error_code(server, "{"), -32700);
  EXPECT_EQ(error_code(server, "\xff"), -32700);
  EXPECT_EQ(error_code(server, deep), -32700);
  EXPECT_EQ(error_code(server, "[]"), -32600);
  EXPECT_EQ(error_code(server, R"({"id":1,"method":"initialize"})"), -32600);
  EXPECT_EQ(error_code(server, R"({"jsonrpc":"2.0","id":[1],"method":"initialize"})"), -32600);
  EXPECT_EQ(error_code(server, R"({"jsonrpc":"2.0","id":1,"method":7})"), -32600);
  EXPECT_EQ(error_code(server, R"({"jsonrpc":"2.0","id":1,"method":"shutdown"})"), -32002);
}

TEST(Lifecycle, UnknownMethodsAndParamsAreRefusedAndNoticesAreNot) {
  Editor editor;
  EXPECT_EQ(error_code(editor.server(), R"({"jsonrpc":"2.0","id":"a","method":"x/y"})"), -32601);
  EXPECT_EQ(error_code(editor.server(),
                       R"({"jsonrpc":"2.0","id":2,"method":"textDocument/hover","params":{}})"),
            -32602);
  EXPECT_EQ(error_code(editor.server(),
                       R"({"jsonrpc":"2.0","id":2,"method":"textDocument/hover","params":
                          {"textDocument":{"uri":"file:///none.bhdl"}}})"),
            -32803);
  EXPECT_TRUE(editor.server().receive(R"({"jsonrpc":"2.0","method":"$/setTrace"})").empty());
  EXPECT_TRUE(editor.server().receive(R"({"jsonrpc":"2.0","id":9,"result":null})").empty());
}

TEST(Lifecycle, APositionBeforeTheTextIsRefused) {
  Editor editor;
  editor.open("a.bhdl", "states:");
  EXPECT_NE(editor.refusal("textDocument/hover", {{"position", {{"line", -1}, {"character", 0}}}}),
            "");
}

TEST(Lifecycle, ANoticeThatCannotBeFollowedIsLogged) {
  Editor editor;
  const auto answers = editor.server().receive(
      R"({"jsonrpc":"2.0","method":"textDocument/didChange","params":
          {"textDocument":{"uri":"file:///x.bhdl"},"contentChanges":[]}})");
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(Json::parse(answers[0])["method"], "window/logMessage");
}

TEST(Lifecycle, AllOpenDocumentsTogetherHaveABound) {
  const std::string half(kMostOpenBytes / 2, ' ');
  Editor editor;
  editor.open("a.bhdl", half);
  editor.open("b.bhdl", half);
  EXPECT_THAT(editor.server().receive(did_open_message("file:///c.bhdl", "x")),
              testing::Contains(testing::HasSubstr("16 MiB")));
  editor.close("a.bhdl");
  EXPECT_THAT(editor.server().receive(did_open_message("file:///c.bhdl", "x")),
              testing::Not(testing::Contains(testing::HasSubstr("16 MiB"))));
}

TEST(Lifecycle, ExitAfterShutdownIsWell) {
  Editor editor;
  EXPECT_TRUE(
      editor.send({{"jsonrpc", "2.0"}, {"id", 5}, {"method", "shutdown"}})["result"].is_null());
  EXPECT_EQ(error_code(editor.server(), R"({"jsonrpc":"2.0","id":6,"method":"shutdown"})"), -32600);
  editor.notify("exit", Json::object());
  EXPECT_EQ(editor.server().exit_status(), 0);
}

TEST(Lifecycle, ExitWithoutShutdownIsNot) {
  Editor editor;
  editor.notify("exit", Json::object());
  EXPECT_EQ(editor.server().exit_status(), 1);
}

TEST(Lifecycle, TheClientsFirstEncodingThatIsKnownIsTaken) {
  EXPECT_EQ(Editor().initialized()["capabilities"]["positionEncoding"], "utf-16");
  const Json offered{{"general", {{"positionEncodings", {"utf-7", "utf-8", "utf-16"}}}}};
  EXPECT_EQ(Editor({}, offered).initialized()["capabilities"]["positionEncoding"], "utf-8");
}

TEST(LspFraming, MessagesComeInAnyPieces) {
  const std::string stream = framed("{\"a\":1}") + "content-type: x\r\nCONTENT-LENGTH:2\r\n\r\n{}";
  Framing framing;
  std::vector<std::string> messages;
  for (const char byte : stream) {
    framing.feed({&byte, 1});
    auto next = framing.next();
    ASSERT_TRUE(next.ok());
    if (next.value()) messages.push_back(*next.value());
  }
  EXPECT_EQ(messages, (std::vector<std::string>{"{\"a\":1}", "{}"}));
}

TEST(LspFraming, AHeadWithoutALengthOrWithTooLargeAOneEndsTheStream) {
  for (const auto& head : {std::string("Content-Type: x\r\n\r\n"), std::string(9000, 'x'),
                           std::string("Content-Length: 99999999999\r\n\r\n")}) {
    Framing framing;
    framing.feed(head);
    EXPECT_FALSE(framing.next().ok()) << head.substr(0, 40);
  }
}

}  // namespace
}  // namespace galilean::bhdl::lsp
