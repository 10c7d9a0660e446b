// SPDX-License-Identifier: BSD-3-Clause
#include "core/json_text.h"

#include <gmock/gmock.h>

#include <string>

namespace galilean {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string nested(std::size_t levels) {
  return std::string(levels, '[') + std::string(levels, ']');
}

TEST(JsonText, WhatIsJsonIsReadAsItIs) {
  for (const auto* text : {"null", "true", "3", "-0.5", "\"a\"", "[]", "{}",
                           R"({"a":[1,{"b":"\u00e9"}]})", R"({"a":1,"a":2})", " [1 , 2] "}) {
    const auto read = read_untrusted_json(text);
    ASSERT_TRUE(read) << text << ": " << read.error().message;
    EXPECT_EQ(read.value(), json::parse(text)) << text;
  }
}

TEST(JsonText, WhatIsNoneIsRefusedInASentence) {
  for (const std::string text :
       {"", "{", "[1,]", "1e999", "nul", "\"\xff\"", "{\"a\":\"\xc3\"}", "[] []"})
    EXPECT_THAT(read_untrusted_json(text).error().message, HasSubstr("not JSON")) << text;
  EXPECT_THAT(read_untrusted_json(std::string_view("\0", 1)).error().message,
              HasSubstr("not JSON"));
}

TEST(JsonText, NestingIsLimitedWhereverItIs) {
  EXPECT_TRUE(read_untrusted_json(nested(kDeepestJson)));
  const std::string one_more = nested(kDeepestJson + 1), far = nested(1'000'000);
  for (const auto& text : {one_more, "[1,2," + one_more + "]", far, "{\"a\":" + far + "}",
                           "[[]," + far + ",{\"b\":" + far + "}]", std::string(1'000'000, '[')})
    EXPECT_THAT(read_untrusted_json(text).error().message, HasSubstr("deeper than 32"))
        << text.substr(0, 20);
  EXPECT_TRUE(read_untrusted_json("\"" + std::string(1000, '[') + "\"")) << "within a string";
  EXPECT_TRUE(read_untrusted_json(R"(["\"", ")" + std::string(100, '[') + R"(\"\\"])"));
}

/// Returns a list of so many empty lists: two values for three bytes, as excess_of counts.
std::string empty_lists(std::size_t count) {
  std::string text = "[[]";
  for (std::size_t i = 1; i < count; ++i) text += ",[]";
  return text + "]";
}

TEST(JsonText, ValuesAreLimitedHoweverTheyAreWritten) {
  const JsonLimits limits{.bytes = 1'000'000, .values = 1000};
  for (const auto& text :
       {empty_lists(1000), "{\"a\":" + empty_lists(1000) + "}", std::string(2000, ','),
        "[" + empty_lists(400) + "," + empty_lists(400) + "]"})
    EXPECT_THAT(read_untrusted_json(text, limits).error().message,
                HasSubstr("more than 1000 values"))
        << text.substr(0, 20);
  EXPECT_TRUE(read_untrusted_json(empty_lists(400), limits));
  EXPECT_TRUE(read_untrusted_json("\"" + std::string(2000, ',') + "\"", limits));
  EXPECT_THAT(read_untrusted_json(empty_lists(4'000'000)).error().message,
              HasSubstr("more than 1000000 values"));
  EXPECT_EQ(read_json(empty_lists(4'000'000)).error().message,
            "the JSON holds more than 1000000 values");
}

TEST(JsonText, BytesAreLimited) {
  const JsonLimits limits{.bytes = 8, .values = 1000};
  EXPECT_TRUE(read_untrusted_json("\"123456\"", limits));
  EXPECT_EQ(read_untrusted_json("\"1234567\"", limits).error().message,
            "This JSON has more than 8 bytes.");
}

TEST(JsonText, AFileThatIsNoneIsToldByItsByte) {
  EXPECT_EQ(read_json(R"({"a": 1})").value(), (json{{"a", 1}}));
  EXPECT_EQ(read_json("[1,]").error().message, "no JSON at byte 4");
  EXPECT_EQ(read_json("").error().message, "no JSON at byte 1");
  EXPECT_EQ(read_json(nested(1'000'000)).error().message, "the JSON nests deeper than 32 levels");
  for (const auto* text : {"1e999", "[0,-1e999]", R"({"a":1e400})"})
    EXPECT_EQ(read_json(text).error().message, "the JSON holds a number that is too large") << text;
}

TEST(JsonText, AnythingCanBePrinted) {
  const json bad{{"a", "\xff"}, {"b", {1, 2}}};
  EXPECT_EQ(json_text(bad), "{\"a\":\"\xef\xbf\xbd\",\"b\":[1,2]}");
  EXPECT_EQ(json_text(json{{"a", "\xff"}}, 1), "{\n \"a\": \"\xef\xbf\xbd\"\n}");
  EXPECT_EQ(ordered_json_text(nlohmann::ordered_json{{"b", 1}, {"a", "\xff"}}),
            "{\"b\":1,\"a\":\"\xef\xbf\xbd\"}");
}

}  // namespace
}  // namespace galilean
