// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/wire/foreign_messages.h"

#include <stdexcept>

#include "core/wire/endpoints.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/types/own_types.h"
#include "core/wire/untyped_topic.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"

namespace galilean::monitor {
namespace {

constexpr const char* kPlain =
    R"({"yes":true,"raw":200,"letter":"q","small":-3,"small_natural":60000,"whole":-70000,)"
    R"("natural":4000000000,"large":-5000000000,"large_natural":18000000000000000000,)"
    R"("near_m":0.1,"exact_m":-2.5,"words":"hall","short_words":"short","present_gear":"DRIVE",)"
    R"("present_faults":["CAMERA","RADIO"],"spot":{"x_m":1.5,"y_m":-0.25},)"
    R"("grid":[[1,2,3],[4,5,6]],"names":["io",""],"gears":["REVERSE","PARK"],"label":"red",)"
    R"("counts":[7,8,9],"bytes":[1,2,255],"answers":[true,false],"spelled":"ok",)"
    R"("numbers":[0.5,1e+300],"lines":["one","two"],"past_gears":["PARK","DRIVE"],)"
    R"("past_faults":[[],["MOTOR"]],"table":[[7,8],[]],"rows":[[1,2,3],[4,5,6]],)"
    R"("trail":[{"x_m":0.25,"y_m":4.0},{"x_m":-1.0,"y_m":0.0}],)"
    R"("present_outline":{"discriminator":"SQUARE","corner":{"x_m":0.5,"y_m":8.0}},)"
    R"("outlines":[{"discriminator":"ROUND","radius_m":3.0},)"
    R"({"discriminator":"SQUARE","corner":{"x_m":2.0,"y_m":1.0}}]})";
constexpr const char* kReport =
    R"({"best":{"words":"best","weight":12},"worst":{"words":"worst","weight":null},)"
    R"("others":[{"words":"dull","weight":null},{"words":"bright","weight":12}],)"
    R"("first":{"discriminator":2,"words":"warm"},)"
    R"("more":[{"discriminator":7,"found":["MOTOR"]},{"discriminator":-1,"code":9}],)"
    R"("spot":{"x_m":3.0,"y_m":0.5},"lost":null,"last":77})";
constexpr const char* kSettings =
    R"({"revision":6,"level":9,"channel":8080,"gain":1.25,"name":"hall","bytes":[3,2,1],)"
    R"("steps":[-1,100000],"ramps":[0.125],"trims":[-5,0,5],"absent":null,)"
    R"("rest":{"x_m":-4.0,"y_m":2.0},"owner":{"words":"io","weight":null},)"
    R"("preferred":"REVERSE","grid":[1,-1]})";

}  // namespace

std::vector<std::uint8_t> foreign_bytes(wire::Foreign message, wire::Cdr version) {
  static const int kEncodersDomain = free_domain();
  const auto encoder = wire::Participant::join("encoder", kEncodersDomain).value();
  const auto decoder = wire::Participant::join("decoder", kEncodersDomain).value();
  wire::ForeignTalk talk(encoder->handle(), message, "rt/encoded", version);
  wire::Reader reader(*decoder,
                      {"rt/encoded", wire::foreign_type(message), message == wire::Foreign::kKeyed},
                      {.reliable = true}, 1);
  std::vector<std::uint8_t> bytes;
  const bool came = talk.write() && wire::wait_until([&] {
                      reader.take([&](const wire::Received& received) {
                        bytes.assign(received.cdr.begin(), received.cdr.end());
                      });
                      return !bytes.empty();
                    });
  if (!came) throw std::runtime_error("the sample did not come");
  return bytes;
}

wire::Type foreign_description(wire::Foreign message) {
  return wire::describe_descriptor(wire::foreign_descriptor(message)).value().description;
}

std::string foreign_json(wire::Foreign message) {
  switch (message) {
    case wire::Foreign::kPlain:
      return kPlain;
    case wire::Foreign::kReport:
      return kReport;
    case wire::Foreign::kSettings:
      return kSettings;
    case wire::Foreign::kKeyed:
      return R"({"id":42,"part":"wheel","words":"turns"})";
    case wire::Foreign::kCells:
      return R"({"cost":-1,"costs":[-1,0,100],"corners":[-2,-1,0,1]})";
    case wire::Foreign::kRobotState:
      return R"({"robot":"io","charge":0.75})";
    case wire::Foreign::kLarge:
    case wire::Foreign::kBare:
      break;
  }
  throw std::runtime_error("no JSON of this sample is kept");
}

}  // namespace galilean::monitor
