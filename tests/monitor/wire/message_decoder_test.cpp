// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/message_decoder.h"

#include <gtest/gtest.h>

#include "core/json_text.h"
#include "tests/monitor/wire/foreign_messages.h"

namespace galilean::monitor {
namespace {

using wire::Cdr;
using wire::Extensibility;
using wire::Foreign;
using wire::Type;
using wire::TypeDescription;
using wire::TypeKind;

using Bytes = std::vector<std::uint8_t>;

std::string decoded(const Type& type, const Bytes& bytes) {
  const auto message = MessageDecoder(type).decode(bytes);
  return message ? ordered_json_text(message.value()) : message.error().message;
}

Type number_type(TypeKind kind, int bytes) {
  return std::make_shared<TypeDescription>(TypeDescription{.kind = kind, .bytes = bytes});
}

/// A struct of two numbers, of which the second is optional.
Type pair_type(Extensibility extensibility) {
  TypeDescription type{.kind = TypeKind::kStruct, .name = "Pair", .extensibility = extensibility};
  type.members = {
      {.name = "a", .id = 1, .type = number_type(TypeKind::kByte, 1)},
      {.name = "b", .id = 2, .type = number_type(TypeKind::kDouble, 8), .optional = true}};
  return std::make_shared<TypeDescription>(type);
}

TEST(MessageDecoder, ReadsWhatCycloneEncodesInTheFirstVersion) {
  for (const auto message : {Foreign::kPlain, Foreign::kKeyed, Foreign::kCells})
    EXPECT_EQ(decoded(foreign_description(message), foreign_bytes(message, Cdr::kFirst)),
              foreign_json(message));
}

TEST(MessageDecoder, ReadsWhatCycloneEncodesInTheSecondVersion) {
  for (const auto message :
       {Foreign::kPlain, Foreign::kReport, Foreign::kSettings, Foreign::kKeyed})
    EXPECT_EQ(decoded(foreign_description(message), foreign_bytes(message, Cdr::kSecond)),
              foreign_json(message));
}

TEST(MessageDecoder, ReadsNumbersOfBigEndian) {
  const auto type = pair_type(Extensibility::kFinal);
  EXPECT_EQ(decoded(type, {0, 6, 0, 0, 5, 1, 0, 0, 0x3F, 0xE0, 0, 0, 0, 0, 0, 0}),
            R"({"a":5,"b":0.5})");
}

TEST(MessageDecoder, AnOptionalFieldOfTheFirstVersionHasAHeader) {
  const auto type = pair_type(Extensibility::kFinal);
  EXPECT_EQ(decoded(type, {0, 1, 0, 0, 5, 0, 0, 0, 2, 0, 8, 0, 0, 0, 0, 0, 0, 0, 0xE0, 0x3F}),
            R"({"a":5,"b":0.5})");
  EXPECT_EQ(decoded(type, {0, 1, 0, 0, 5, 0, 0, 0, 2, 0, 0, 0}), R"({"a":5,"b":null})");
}

TEST(MessageDecoder, ReadsAMutableStructOfTheFirstVersionInAnyOrder) {
  const auto type = pair_type(Extensibility::kMutable);
  EXPECT_EQ(decoded(type, {0, 3, 0, 0, 2, 0, 8, 0, 0, 0, 0, 0, 0, 0, 0xE0, 0x3F, 9, 0,
                           4, 0, 1, 2, 3, 4, 1, 0, 1, 0, 7, 0, 0, 0, 2,    0x3F, 0, 0}),
            R"({"a":7,"b":0.5})");
  EXPECT_EQ(decoded(type, {0, 3, 0, 0, 2, 0x3F, 0, 0}), R"({"a":null,"b":null})");
}

TEST(MessageDecoder, WhatAWriterAppendedIsSkippedAndWhatItDoesNotHaveIsNull) {
  const auto type = pair_type(Extensibility::kAppendable);
  EXPECT_EQ(decoded(type, {0, 9, 0, 0, 1, 0, 0, 0, 5}), R"({"a":5,"b":null})");
  EXPECT_EQ(decoded(type, {0, 9, 0, 0, 4, 0, 0, 0, 5, 0, 9, 9}), R"({"a":5,"b":null})");
}

TEST(MessageDecoder, UnknownValuesOfAnEnumAndUnknownFlagsAreNumbers) {
  TypeDescription gear{.kind = TypeKind::kEnum, .bytes = 1, .constants = {{"PARK", 0}}};
  TypeDescription faults{.kind = TypeKind::kBitmask, .bytes = 1, .constants = {{"CAMERA", 1}}};
  EXPECT_EQ(decoded(std::make_shared<TypeDescription>(gear), {0, 1, 0, 0, 9}), "9");
  EXPECT_EQ(decoded(std::make_shared<TypeDescription>(faults), {0, 1, 0, 0, 6}),
            R"(["CAMERA","bit 2"])");
}

TEST(MessageDecoder, AMessageThatIsCutShortIsRefusedWherever) {
  const auto type = foreign_description(Foreign::kPlain);
  const auto whole = foreign_bytes(Foreign::kPlain, Cdr::kSecond);
  const auto filled_up = static_cast<std::size_t>(whole[3] & 3);
  for (std::size_t size = 0; size < whole.size() - filled_up; ++size)
    EXPECT_EQ(decoded(type, {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}),
              "a message is not a whole foreign::Plain")
        << size;
}

}  // namespace
}  // namespace galilean::monitor
