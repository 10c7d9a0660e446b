// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/describe_type.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <deque>
#include <vector>

#include "core/wire/type_hash.h"
#include "core/wire/types/own_types.h"
#include "core/wire/unwrapped.h"
#include "tests/core/wire/types/foreign_talk.h"

namespace galilean::wire {
namespace {

Type described(Foreign message) {
  auto type = describe_descriptor(foreign_descriptor(message));
  if (!type) throw std::runtime_error(type.error().message);
  return type.value().description;
}

const TypeMember& member_of(const Type& type, const std::string& name) {
  for (const auto& member : type->members)
    if (member.name == name) return member;
  throw std::runtime_error(type->name + " has no " + name);
}

const TypeDescription& type_of(const Type& type, const std::string& name) {
  return *member_of(type, name).type;
}

Result<Type> describe(const DDS_XTypes_TypeIdentifier& id) {
  return describe_type(id, [](const std::string&) -> Result<const DDS_XTypes_TypeObject*> {
    return Error{"was not told in time"};
  });
}

TEST(DescribeType, TellsPrimitiveTypesWithTheirSizes) {
  const auto plain = described(Foreign::kPlain);
  EXPECT_EQ(plain->kind, TypeKind::kStruct);
  EXPECT_EQ(plain->name, "foreign::Plain");
  EXPECT_EQ(plain->extensibility, Extensibility::kFinal);
  const std::pair<const char*, std::pair<TypeKind, int>> expected[] = {
      {"yes", {TypeKind::kBoolean, 1}},          {"raw", {TypeKind::kByte, 1}},
      {"letter", {TypeKind::kChar, 1}},          {"small", {TypeKind::kInt16, 2}},
      {"small_natural", {TypeKind::kUint16, 2}}, {"whole", {TypeKind::kInt32, 4}},
      {"natural", {TypeKind::kUint32, 4}},       {"large", {TypeKind::kInt64, 8}},
      {"large_natural", {TypeKind::kUint64, 8}}, {"near_m", {TypeKind::kFloat, 4}},
      {"exact_m", {TypeKind::kDouble, 8}}};
  for (const auto& [name, kind] : expected) {
    EXPECT_EQ(type_of(plain, name).kind, kind.first) << name;
    EXPECT_EQ(type_of(plain, name).bytes, kind.second) << name;
  }
}

TEST(DescribeType, TellsTextsArraysAndSequencesWithTheirBounds) {
  const auto plain = described(Foreign::kPlain);
  EXPECT_EQ(type_of(plain, "words").kind, TypeKind::kString);
  EXPECT_TRUE(type_of(plain, "words").bounds.empty());
  EXPECT_EQ(type_of(plain, "short_words").bounds, std::vector<std::uint32_t>{8});
  EXPECT_EQ(type_of(plain, "grid").kind, TypeKind::kArray);
  EXPECT_EQ(type_of(plain, "grid").bounds, (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(type_of(plain, "bytes").kind, TypeKind::kSequence);
  EXPECT_TRUE(type_of(plain, "bytes").bounds.empty());
  EXPECT_EQ(type_of(plain, "trail").bounds, std::vector<std::uint32_t>{4});
  EXPECT_EQ(type_of(plain, "trail").element->name, "foreign::Point");
  EXPECT_EQ(type_of(plain, "table").element->element->kind, TypeKind::kInt32);
  EXPECT_EQ(type_of(plain, "rows").element->bounds, std::vector<std::uint32_t>{3});
}

TEST(DescribeType, TellsTheNamesOfEnumsAndBitmasks) {
  const auto plain = described(Foreign::kPlain);
  const auto& gear = type_of(plain, "present_gear");
  EXPECT_EQ(gear.kind, TypeKind::kEnum);
  EXPECT_EQ(gear.bytes, 1);
  ASSERT_EQ(gear.constants.size(), 3U);
  EXPECT_EQ(gear.constants[1].name, "DRIVE");
  EXPECT_EQ(gear.constants[1].value, 5);
  const auto& faults = type_of(plain, "present_faults");
  EXPECT_EQ(faults.kind, TypeKind::kBitmask);
  EXPECT_EQ(faults.bytes, 2);
  ASSERT_EQ(faults.constants.size(), 3U);
  EXPECT_EQ(faults.constants[2].name, "RADIO");
  EXPECT_EQ(faults.constants[2].value, 9);
}

TEST(DescribeType, TellsWhatSelectsAUnionsFields) {
  const auto report = described(Foreign::kReport);
  const auto& reading = type_of(report, "first");
  EXPECT_EQ(reading.kind, TypeKind::kUnion);
  EXPECT_EQ(reading.extensibility, Extensibility::kAppendable);
  EXPECT_EQ(reading.element->kind, TypeKind::kInt32);
  ASSERT_EQ(reading.members.size(), 3U);
  EXPECT_EQ(reading.members[0].labels, (std::vector<std::int32_t>{1, 2}));
  EXPECT_FALSE(reading.members[1].otherwise);
  EXPECT_TRUE(reading.members[2].otherwise);
}

TEST(DescribeType, TellsKeysOptionalFieldsAndThoseOfTheBase) {
  const auto keyed = described(Foreign::kKeyed);
  EXPECT_TRUE(member_of(keyed, "id").key);
  EXPECT_FALSE(member_of(keyed, "words").key);
  const auto report = described(Foreign::kReport);
  EXPECT_EQ(report->extensibility, Extensibility::kAppendable);
  EXPECT_TRUE(member_of(report, "spot").optional);
  EXPECT_FALSE(member_of(report, "best").optional);
  const auto settings = described(Foreign::kSettings);
  EXPECT_EQ(settings->extensibility, Extensibility::kMutable);
  EXPECT_EQ(settings->members.front().name, "revision");
  EXPECT_EQ(settings->members.front().id, 10U);
  EXPECT_EQ(member_of(settings, "level").id, 3U);
}

TEST(DescribeType, CyclonesCharactersAreNumbersInTypesOfRos) {
  const auto cells = described(Foreign::kCells);
  EXPECT_EQ(type_of(cells, "cost").kind, TypeKind::kInt8);
  EXPECT_EQ(type_of(cells, "costs").element->kind, TypeKind::kInt8);
  EXPECT_EQ(type_of(cells, "corners").element->kind, TypeKind::kInt8);
}

TEST(DescribeType, GalileansOwnTypesAreKnownByTheirNamesOnDds) {
  const auto* state = find_own_type("galilean_msgs::msg::dds_::RobotState_");
  ASSERT_NE(state, nullptr);
  EXPECT_EQ(state->hash.size(), 28U);
  EXPECT_EQ(state->description->name, "galilean_msgs::msg::RobotState");
  EXPECT_EQ(type_of(state->description, "stamp").name, "builtin_interfaces::msg::Time");
  EXPECT_EQ(find_own_type("foreign::Plain"), nullptr);
  EXPECT_FALSE(describe_descriptor(foreign_descriptor(Foreign::kBare)).ok());
}

TEST(DescribeType, WhatCannotBeDecodedIsToldInAClause) {
  const std::pair<std::uint8_t, const char*> expected[] = {
      {DDS_XTypes_TK_FLOAT128, "holds a floating-point number of 128 bits"},
      {DDS_XTypes_TI_STRING16_SMALL, "holds a text of wide characters"},
      {DDS_XTypes_TI_PLAIN_MAP_SMALL, "holds a map"},
      {DDS_XTypes_EK_MINIMAL, "is published without the names of its fields"},
      {DDS_XTypes_EK_COMPLETE, "was not told in time"},
      {0xEE, "holds a value of the unknown kind 238"}};
  for (const auto& [kind, clause] : expected) {
    DDS_XTypes_TypeIdentifier id{};
    id._d = kind;
    const auto type = describe(id);
    ASSERT_FALSE(type.ok()) << clause;
    EXPECT_EQ(type.error().message, clause);
  }
}

TEST(DescribeType, RefusesToNestWithoutEnd) {
  std::deque<DDS_XTypes_TypeIdentifier> nest(1);
  nest.front()._d = DDS_XTypes_TK_BYTE;
  const auto wrap = [&] {
    auto* inner = &nest.back();
    auto& outer = nest.emplace_back();
    outer._d = DDS_XTypes_TI_PLAIN_SEQUENCE_SMALL;
    outer._u.seq_sdefn.element_identifier = inner;
  };
  for (int depth = 0; depth < 32; ++depth) wrap();
  EXPECT_TRUE(describe(nest.back()).ok());
  wrap();
  EXPECT_FALSE(describe(nest.back()).ok());
}

/// Structs that hold one another by their hashes: number 0 holds a byte, and each other one the one
/// before it. The outermost holds all of them, the shallowest first.
class SharedStructs {
 public:
  explicit SharedStructs(int count) : members_(count + 1), objects_(count + 1) {
    for (int i = 0; i < count; ++i) hold(i, {i == 0 ? byte() : type_identifier(hash_of(i - 1))});
    std::vector<DDS_XTypes_TypeIdentifier> all;
    for (int i = 0; i < count; ++i) all.push_back(type_identifier(hash_of(i)));
    hold(count, all);
  }
  [[nodiscard]] Result<Type> describe_outermost() const {
    const int outermost = static_cast<int>(objects_.size()) - 1;
    return describe_type(type_identifier(hash_of(outermost)), [this](const std::string& hash) {
      return Result<const DDS_XTypes_TypeObject*>(&objects_.at(std::stoul(hash, nullptr, 16)));
    });
  }

 private:
  static std::string hash_of(int number) {
    char digits[29];
    std::snprintf(digits, sizeof digits, "%028x", static_cast<unsigned>(number));
    return digits;
  }
  static DDS_XTypes_TypeIdentifier byte() {
    DDS_XTypes_TypeIdentifier id{};
    id._d = DDS_XTypes_TK_BYTE;
    return id;
  }
  void hold(int number, const std::vector<DDS_XTypes_TypeIdentifier>& ids) {
    auto& members = members_.at(number);
    for (const auto& id : ids) members.emplace_back().common.member_type_id = id;
    auto& object = objects_.at(number);
    object._d = DDS_XTypes_EK_COMPLETE;
    object._u.complete._d = DDS_XTypes_TK_STRUCTURE;
    auto& held = object._u.complete._u.struct_type.member_seq;
    held._buffer = members.data();
    held._length = static_cast<std::uint32_t>(members.size());
  }

  std::vector<std::vector<DDS_XTypes_CompleteStructMember>> members_;
  std::vector<DDS_XTypes_TypeObject> objects_;
};

TEST(DescribeType, ATypeThatIsUsedTwiceCountsWithAllThatItHolds) {
  EXPECT_TRUE(SharedStructs(31).describe_outermost().ok());
  const auto deeper = SharedStructs(32).describe_outermost();
  ASSERT_FALSE(deeper.ok());
  EXPECT_EQ(deeper.error().message, "nests deeper than 32 levels");
}

TEST(DescribeType, ASequenceOfNothingIsRefused) {
  DDS_XTypes_TypeIdentifier id{};
  id._d = DDS_XTypes_TI_PLAIN_SEQUENCE_LARGE;
  EXPECT_FALSE(describe(id).ok());
  id._d = DDS_XTypes_TI_PLAIN_ARRAY_SMALL;
  EXPECT_FALSE(describe(id).ok());
}

}  // namespace
}  // namespace galilean::wire
