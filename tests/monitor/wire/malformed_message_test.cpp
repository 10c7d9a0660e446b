// SPDX-License-Identifier: BSD-3-Clause
// What the network may send instead of messages. AddressSanitizer sees what reads too far.
#include <gtest/gtest.h>

#include <random>

#include "monitor/wire/message_text.h"
#include "tests/monitor/wire/foreign_messages.h"

namespace galilean::monitor {
namespace {

using wire::Cdr;
using wire::Foreign;
using wire::Type;
using wire::TypeDescription;
using wire::TypeKind;

using Bytes = std::vector<std::uint8_t>;

constexpr Foreign kAll[] = {Foreign::kPlain, Foreign::kReport, Foreign::kSettings,
                            Foreign::kKeyed, Foreign::kCells,  Foreign::kRobotState};

std::size_t values_in(const MessageTree& tree) {
  std::size_t count = 1;
  if (tree.is_structured())
    for (const auto& item : tree) count += values_in(item);
  return count;
}

/// Decodes and prints without a crash, to no more than a message of that size can hold.
void decode_safely(const Type& type, const Bytes& bytes) {
  const auto message = MessageDecoder(type).decode(bytes);
  if (!message) {
    EXPECT_EQ(message.error().message, "a message is not a whole " + type->name);
    return;
  }
  EXPECT_LE(values_in(message.value()), 3 * bytes.size() + 200'000);
  EXPECT_FALSE(readable_text(message.value()).empty());
}

Type struct_of(const char* name, std::vector<wire::TypeMember> members) {
  TypeDescription type{.kind = TypeKind::kStruct, .name = name, .members = std::move(members)};
  return std::make_shared<TypeDescription>(std::move(type));
}

TEST(MalformedMessage, RandomBytesNeverCrash) {
  std::mt19937 random(1);
  for (const auto message : kAll) {
    const auto type = foreign_description(message);
    for (int round = 0; round < 3000; ++round) {
      Bytes bytes(random() % 200);
      for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
      if (bytes.size() > 1) bytes[0] = 0, bytes[1] %= 12;
      decode_safely(type, bytes);
    }
  }
}

TEST(MalformedMessage, RightMessagesWithWrongBytesNeverCrash) {
  std::mt19937 random(2);
  constexpr std::uint8_t kNasty[] = {0, 1, 0x7F, 0x80, 0xFF};
  for (const auto message : kAll) {
    const auto type = foreign_description(message);
    const auto right = foreign_bytes(message, Cdr::kSecond);
    for (int round = 0; round < 3000; ++round) {
      auto bytes = right;
      for (auto wrong = random() % 4 + 1; wrong > 0; --wrong)
        bytes[random() % bytes.size()] = random() % 2 ? kNasty[random() % std::size(kNasty)]
                                                      : static_cast<std::uint8_t>(random());
      if (random() % 4 == 0) bytes.resize(random() % bytes.size());
      decode_safely(type, bytes);
    }
  }
}

TEST(MalformedMessage, ASequenceOfNothingsDoesNotFillTheMemory) {
  const auto nothing = struct_of("Nothing", {});
  TypeDescription many{.kind = TypeKind::kSequence, .element = nothing};
  const auto type = struct_of(
      "Many", {{.name = "many", .type = std::make_shared<TypeDescription>(std::move(many))}});
  decode_safely(type, {0, 1, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF});
}

TEST(MalformedMessage, AnArrayOfArraysOfNothingEnds) {
  TypeDescription grid{.kind = TypeKind::kArray,
                       .element = struct_of("Nothing", {}),
                       .bounds = {4'000'000'000, 4'000'000'000, 4'000'000'000}};
  const auto type = struct_of(
      "Grid", {{.name = "grid", .type = std::make_shared<TypeDescription>(std::move(grid))}});
  decode_safely(type, {0, 1, 0, 0});
}

TEST(MalformedMessage, StructsThatHoldTwoOfTheNextEnd) {
  auto type = struct_of("Nothing", {});
  for (int depth = 0; depth < 32; ++depth)
    type = struct_of("Twice", {{.name = "a", .type = type}, {.name = "b", .type = type}});
  decode_safely(type, {0, 1, 0, 0});
}

}  // namespace
}  // namespace galilean::monitor
