// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/type_finder.h"

#include <gtest/gtest.h>

#include "core/wire/endpoints.h"
#include "core/wire/types/own_types.h"
#include "core/wire/types/type_text.h"
#include "tests/core/wire/types/foreign_talk.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"

namespace galilean::wire {
namespace {

const int kFindersDomain = free_domain();

struct Neighbours {
  std::unique_ptr<Participant> own = Participant::join("own", kFindersDomain).value();
  ForeignProcess foreign{"talker", kFindersDomain};
};

/// Returns the writer of a topic once it is known.
EndpointInfo writer_of(Endpoints& endpoints, const std::string& topic) {
  EndpointInfo writer;
  EXPECT_TRUE(wait_until([&] {
    for (const auto& end : endpoints.known())
      if (end.writes && end.topic == topic && end.process == "talker") return writer = end, true;
    return false;
  }));
  return writer;
}

/// Gives up an answer after so many times of 50 ms.
std::function<bool()> after(int times) {
  return [times]() mutable { return times-- <= 0; };
}

TEST(TypeFinder, LearnsFromAnotherProcessWhatItsTypesAreMadeOf) {
  Neighbours both;
  TypeFinder finder(*both.own);
  Endpoints endpoints(*both.own);
  for (const auto message : {Foreign::kPlain, Foreign::kReport, Foreign::kSettings}) {
    const std::string topic = "rt/learnt/" + std::to_string(static_cast<int>(message));
    const ForeignTalk talk(both.foreign.participant(), message, topic, Cdr::kSecond);
    const auto told = describe_descriptor(foreign_descriptor(message)).value();
    const auto writer = writer_of(endpoints, topic);
    EXPECT_EQ(writer.type_hash, told.hash);
    const auto type = finder.find(writer.type_hash, after(200));
    ASSERT_TRUE(type.ok()) << type.error().message;
    EXPECT_EQ(type_text(type.value()), type_text(told.description));
  }
}

TEST(TypeFinder, GivesUpWhereNobodyKnowsTheType) {
  Neighbours both;
  TypeFinder finder(*both.own);
  const auto type = finder.find(std::string(28, '5'), after(2));
  ASSERT_FALSE(type.ok());
  EXPECT_EQ(type.error().message, "was not told in time");
}

TEST(TypeFinder, AnEndpointTellsNoHashWithoutTypeInformation) {
  Neighbours both;
  Endpoints endpoints(*both.own);
  const ForeignTalk bare(both.foreign.participant(), Foreign::kBare, "rt/bare", Cdr::kFirst);
  const ForeignTalk keyed(both.foreign.participant(), Foreign::kKeyed, "rt/keyed", Cdr::kFirst);
  EXPECT_EQ(writer_of(endpoints, "rt/bare").type_hash, "");
  EXPECT_FALSE(writer_of(endpoints, "rt/bare").keyed);
  EXPECT_TRUE(writer_of(endpoints, "rt/keyed").keyed);
}

}  // namespace
}  // namespace galilean::wire
