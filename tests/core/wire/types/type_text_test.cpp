// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/type_text.h"

#include <gtest/gtest.h>

#include "core/wire/types/own_types.h"
#include "tests/core/wire/types/foreign_talk.h"

namespace galilean::wire {
namespace {

std::string text_of(Foreign message) {
  return type_text(describe_descriptor(foreign_descriptor(message)).value().description);
}

TEST(TypeText, IsIdlWithWhatATypeIsMadeOfFirst) {
  EXPECT_EQ(text_of(Foreign::kReport),
            "module foreign {\n"
            "@appendable struct Tag {\n"
            "  string words;\n"
            "  @optional long weight;\n"
            "};\n"
            "};\n"
            "\n"
            "module foreign {\n"
            "@bit_bound(16) bitmask Faults {\n"
            "  @position(0) CAMERA,\n"
            "  @position(3) MOTOR,\n"
            "  @position(9) RADIO\n"
            "};\n"
            "};\n"
            "\n"
            "module foreign {\n"
            "@appendable union Reading switch (long) {\n"
            "  case 1:\n"
            "  case 2:\n"
            "    string words;\n"
            "  case 7:\n"
            "    foreign::Faults found;\n"
            "  default:\n"
            "    octet code;\n"
            "};\n"
            "};\n"
            "\n"
            "module foreign {\n"
            "@final struct Point {\n"
            "  double x_m;\n"
            "  float y_m;\n"
            "};\n"
            "};\n"
            "\n"
            "module foreign {\n"
            "@appendable struct Report {\n"
            "  foreign::Tag best;\n"
            "  foreign::Tag worst;\n"
            "  sequence<foreign::Tag> others;\n"
            "  foreign::Reading first;\n"
            "  sequence<foreign::Reading> more;\n"
            "  @optional foreign::Point spot;\n"
            "  @optional foreign::Point lost;\n"
            "  octet last;\n"
            "};\n"
            "};\n");
}

TEST(TypeText, NamesKeysBoundsSizesAndIds) {
  EXPECT_NE(text_of(Foreign::kKeyed).find("  @key string<16> part;\n"), std::string::npos);
  const auto settings = text_of(Foreign::kSettings);
  EXPECT_NE(settings.find("  @optional @id(12) long absent;\n"), std::string::npos) << settings;
  const auto plain = text_of(Foreign::kPlain);
  for (const char* line : {"  long grid[2][3];\n", "  sequence<foreign::Point, 4> trail;\n",
                           "  sequence<sequence<long> > table;\n", "  sequence<long[3]> rows;\n",
                           "  case SQUARE:\n    foreign::Point corner;\n",
                           "@bit_bound(8) enum Gear {\n  @value(0) PARK,\n"})
    EXPECT_NE(plain.find(line), std::string::npos) << line << plain;
}

TEST(TypeText, ShowsNoControlCharacters) {
  TypeDescription type{.kind = TypeKind::kStruct, .name = "a\x1b[1mb"};
  const auto text = type_text(std::make_shared<TypeDescription>(type));
  EXPECT_EQ(text.find('\x1b'), std::string::npos) << text;
}

}  // namespace
}  // namespace galilean::wire
