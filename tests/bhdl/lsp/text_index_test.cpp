// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/text_index.h"

#include <gtest/gtest.h>

#include "bhdl/lsp/documents/uri.h"
#include "tests/bhdl/lsp/editor.h"

namespace galilean::bhdl::lsp {
namespace {

TEST(TextIndex, CountsInWhatTheClientCounts) {
  const std::string text = "a\n; 🧹é “x”\nz";
  const TextIndex index(text);
  const std::size_t quote = text.find("“");
  EXPECT_EQ(index.position(quote, PositionEncoding::kUtf8).character, quote - 2);
  EXPECT_EQ(index.position(quote, PositionEncoding::kUtf16).character, 6u);
  EXPECT_EQ(index.position(quote, PositionEncoding::kUtf32).character, 5u);
  for (const auto encoding :
       {PositionEncoding::kUtf8, PositionEncoding::kUtf16, PositionEncoding::kUtf32})
    EXPECT_EQ(index.offset(index.position(quote, encoding), encoding), quote);
}

TEST(TextIndex, LinesEndAsInBhdl) {
  const TextIndex index("a\r\nb\rc\nd");
  EXPECT_EQ(index.line_count(), 4u);
  EXPECT_EQ(index.line(0), "a");
  EXPECT_EQ(index.line_of(3), 1u);
  EXPECT_EQ(index.offset({2, 0}, PositionEncoding::kUtf16), 5u);
}

TEST(TextIndex, PlacesOutsideAreTheNearestInside) {
  const TextIndex index("ab\ncd");
  EXPECT_EQ(index.offset({0, 99}, PositionEncoding::kUtf16), 2u);
  EXPECT_EQ(index.offset({9, 0}, PositionEncoding::kUtf16), 5u);
}

TEST(TextIndex, AByteOrderMarkIsNoColumnOfADiagnostic) {
  EXPECT_EQ(TextIndex("\uFEFFvariables:").offset_of_place(1, 1), 3u);
}

TEST(Uri, PathsComeBack) {
  const std::string path = "/home/ada/my robots/größe#1.bhdl";
  EXPECT_EQ(uri_of("/a b"), "file:///a%20b");
  EXPECT_EQ(path_of(uri_of(path)), path);
  EXPECT_EQ(path_of("file:///a/../b%2Ebhdl"), "/b.bhdl");
  EXPECT_EQ(path_of("untitled:Untitled-1"), "untitled:Untitled-1");
}

TEST(Sync, ChangesApplyOneAfterTheOther) {
  Editor editor;
  editor.open("a.bhdl", "; 🧹\nstates:\n");
  editor.change(
      "a.bhdl",
      {{{"range",
         {{"start", {{"line", 0}, {"character", 4}}}, {"end", {{"line", 1}, {"character", 0}}}}},
        {"text", "x\n\n"}},
       {{"range",
         {{"start", {{"line", 2}, {"character", 0}}}, {"end", {{"line", 2}, {"character", 6}}}}},
        {"text", "nonsense"}}});
  EXPECT_EQ(editor.published("a.bhdl")["version"], 2);
  EXPECT_EQ(editor.problems("a.bhdl"), "2:0-2:8 syntax/unexpected-token\n");
}

TEST(Sync, AWholeTextReplacesWhatWasThere) {
  Editor editor;
  editor.open("a.bhdl", "nonsense");
  editor.change("a.bhdl", {{{"text", "; empty\n"}}});
  EXPECT_EQ(editor.problems("a.bhdl"), "0:0-0:0 state/none\n");
}

}  // namespace
}  // namespace galilean::bhdl::lsp
