// SPDX-License-Identifier: BSD-3-Clause
// What clients send that makes no sense: each gets a sentence, and nobody else notices.
#include <fstream>

#include "tests/monitor/server/bad_requests.h"
#include "tests/monitor/server/foxglove/foxglove_socket.h"
#include "tests/monitor/server/server_fixture.h"

namespace galilean::monitor {
namespace {

namespace http = boost::beast::http;
using nlohmann::json;
using testing::EndsWith;
using testing::HasSubstr;

class BadRequestTest : public ServerFixture {
 protected:
  void SetUp() override {
    ServerFixture::SetUp();
    operator_socket = std::make_unique<FoxgloveSocket>(host(), monitor->port(), std::string(),
                                                       "/ws?token=" + token("operator.token"));
    services = operator_socket->services();
  }
  void TearDown() override {
    operator_socket.reset();
    ServerFixture::TearDown();
  }

  [[nodiscard]] std::string token(const std::string& file) const {
    const auto header = bearer(file).at("Authorization");
    return header.substr(header.find(' ') + 1);
  }
  [[nodiscard]] std::uint32_t id_of(const std::string& service) const {
    for (const auto& each : services)
      if (each["name"] == service) return each["id"];
    return 0;
  }
  /// Why the monitor does not do what `body` asks of a service.
  std::string failure(std::uint32_t service_id, const std::string& body) {
    operator_socket->send_binary(service_call(service_id, ++calls, body));
    const auto failed = operator_socket->read_op("serviceCallFailure");
    EXPECT_EQ(failed["callId"], calls);
    EXPECT_EQ(failed["serviceId"], service_id);
    return failed["message"];
  }

  std::unique_ptr<FoxgloveSocket> operator_socket;
  json services;
  std::uint32_t calls = 0;
};

TEST_F(BadRequestTest, ABadCallBehindManyRequestsFailsAndTheMonitorServesOn) {
  std::string frames;
  for (int i = 0; i < 40; ++i)
    frames += client_frame(true, R"({"op":"getParameters","parameterNames":[]})");
  frames += client_frame(false, service_call(id_of("/galilean/push"), 5, "[]"));
  operator_socket->send_at_once(frames);
  for (int i = 0; i < 40; ++i) (void)operator_socket->read_op("parameterValues");
  const auto failed = operator_socket->read_op("serviceCallFailure");
  EXPECT_EQ(failed["callId"], 5);
  EXPECT_EQ(failed["message"], "The body must be a JSON object; it is an array.");
  EXPECT_THAT(failure(id_of("/galilean/hold"), "3"), HasSubstr("it is a number"));
  FoxgloveSocket other(host(), monitor->port());
  EXPECT_EQ(other.services().size(), services.size());
  EXPECT_EQ(get("/healthz").status, 200U);
}

TEST_F(BadRequestTest, EveryServiceSaysWhyABodyIsNone) {
  ASSERT_FALSE(services.empty());
  for (const auto& service : services)
    for (const auto& body : bodies_that_are_no_objects())
      EXPECT_THAT(failure(service["id"], body), EndsWith("."))
          << service["name"] << ' ' << body.substr(0, 40);
}

TEST_F(BadRequestTest, EveryServiceNamesTheFieldThatHasTheWrongType) {
  for (const auto& service : services) {
    const auto schema = json::parse(service["request"]["schema"].get<std::string>());
    for (const auto& [name, field] : schema["properties"].items())
      for (const auto& wrong : values_that_are_no(field)) {
        json body = schema["properties"].contains("files") ? json{{"files", files(kProgram)}}
                                                           : json::object();
        body[name] = wrong;
        EXPECT_THAT(failure(service["id"], body.dump()), HasSubstr("'" + name + "'"))
            << service["name"] << ' ' << body;
      }
  }
}

TEST_F(BadRequestTest, ATrialsFieldsAreReadAsCarefully) {
  for (const json& trial :
       {json{{"only", 3}}, json{{"even_if_worse", "x"}}, json{{"seeds", 0}}, json{{"seeds", 1e300}},
        json{{"seeds", 1.5}}, json{{"seeds", (std::int64_t{1} << 32) + 8}},
        json{{"duration_s", -1}}, json{{"duration_s", nullptr}}, json{{"scenario", json::array()}}})
    EXPECT_THAT(
        failure(id_of("/galilean/push"), json{{"files", files(kProgram)}, {"try", trial}}.dump()),
        HasSubstr("'" + trial.begin().key() + "'"))
        << trial;
}

TEST_F(BadRequestTest, NoBumperIsPushedThatIsNotThere) {
  for (const std::int64_t argument :
       {std::int64_t{-1}, std::int64_t{8}, std::int64_t{4294967297}, std::int64_t{99999999999999}})
    EXPECT_THAT(failure(id_of("/galilean/push_bumper"), json{{"argument", argument}}.dump()),
                HasSubstr("'argument' must be a whole number from 0 to 7"))
        << argument;
}

TEST_F(BadRequestTest, EveryOperationNamesTheFieldThatHasTheWrongType) {
  const json list{{"type", "array"}}, text{{"type", "string"}};
  const std::map<std::string, std::map<std::string, json>> fields{
      {"subscribe", {{"subscriptions", list}}},
      {"unsubscribe", {{"subscriptionIds", list}}},
      {"getParameters", {{"parameterNames", list}, {"id", text}}},
      {"setParameters", {{"parameters", list}, {"id", text}}},
      {"subscribeParameterUpdates", {{"parameterNames", list}}},
      {"unsubscribeParameterUpdates", {{"parameterNames", list}}}};
  for (const auto& [op, its] : fields)
    for (const auto& [name, field] : its)
      for (const auto& wrong : values_that_are_no(field)) {
        json message{{"op", op}, {"parameters", json::array()}};
        message[name] = wrong;
        operator_socket->send(message);
        const std::string told = operator_socket->read_op("status")["message"];
        const bool is_item = wrong.is_array() && !wrong.empty();
        EXPECT_THAT(told, HasSubstr(is_item ? "." : "'" + name + "'")) << op << wrong;
      }
}

TEST_F(BadRequestTest, AMessageThatIsNoneIsToldSo) {
  for (const auto& body : bodies_that_are_no_objects()) {
    if (body.find('\xff') != body.npos)
      continue;  // what is no UTF-8 ends a WebSocket (RFC 6455, 8.1)
    operator_socket->send_at_once(client_frame(true, body));
    EXPECT_THAT(operator_socket->read_op("status")["message"].get<std::string>(), EndsWith("."))
        << body.substr(0, 40);
  }
  const auto deep = R"({"op":"unsubscribe","subscriptionIds":)" + deep_json() + "}";
  operator_socket->send_at_once(client_frame(true, deep));
  EXPECT_THAT(operator_socket->read_op("status")["message"].get<std::string>(),
              HasSubstr("nests deeper"));
}

/// Of docs/openapi.yaml, which the end-to-end tests hold to be complete; {…} is filled in.
std::vector<std::string> described_paths(const std::string& method) {
  std::vector<std::string> paths;
  std::ifstream in(std::string(GALILEAN_SOURCE_DIR) + "/docs/openapi.yaml");
  std::string path;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("  /")) path = line.substr(2, line.size() - 3);
    if (line == "    " + method + ":") paths.push_back(path);
  }
  return paths;
}

std::string filled(const std::string& path, const std::string& value) {
  const auto begin = path.find('{'), end = path.find('}');
  return begin == path.npos ? path : path.substr(0, begin) + value + path.substr(end + 1);
}

TEST_F(BadRequestTest, EveryPostSaysWhyABodyIsNone) {
  const auto paths = described_paths("post");
  ASSERT_GE(paths.size(), 4U);
  for (const auto& path : paths)
    for (const auto& body : bodies_that_are_no_objects()) {
      const auto answer =
          request(http::verb::post, filled(path, "nothing"), body, bearer("operator.token"));
      EXPECT_TRUE(answer.status >= 400 && answer.status < 500)
          << path << ' ' << body.substr(0, 40) << ": " << answer.status;
      EXPECT_EQ(answer.type, "application/problem+json");
      EXPECT_THAT(answer.as_json()["detail"].get<std::string>(), EndsWith("."));
    }
  EXPECT_EQ(get("/healthz").status, 200U);
}

TEST_F(BadRequestTest, EveryPostNamesTheFieldThatHasTheWrongType) {
  const json text{{"type", "string"}}, list{{"type", "array"}}, number{{"type", "number"}};
  const std::map<std::string, json> fields{
      {"/api/check", {{"files", list}, {"robot", text}, {"against", list}}},
      {"/api/push", {{"targets", list}, {"author", text}, {"replaces", text}, {"canary", text}}},
      {"/api/pushes/nothing/cancel", {{"author", text}}},
      {"/api/command", {{"kind", text}, {"targets", list}, {"author", text}}},
      {"/api/breaks", {{"order", text}, {"targets", list}, {"author", text}, {"points", list}}},
      {"/api/lease", {{"do", text}, {"robots", list}, {"reason", text}}},
      {"/api/simulation/orders",
       {{"order", text},
        {"subject", text},
        {"part", text},
        {"fault", text},
        {"simulation", text},
        {"author", text},
        {"x_m", number},
        {"y_m", number},
        {"heading_rad", number},
        {"impulse_ns", number},
        {"duration_s", number},
        {"rate", number}}}};
  for (const auto& path : described_paths("post")) {
    const auto its = fields.find(filled(path, "nothing"));
    if (its == fields.end()) {
      ADD_FAILURE() << path << " is new: list its fields above";
      continue;
    }
    for (const auto& [name, field] : its->second.items())
      for (const auto& wrong : values_that_are_no(field)) {
        json body{{"files", files(kProgram)}, {"kind", "hold"}, {"order", "pause"}};
        body[name] = wrong;
        const auto answer = post(its->first, body);
        EXPECT_EQ(answer.status, 400U) << path << ' ' << body;
        EXPECT_THAT(answer.body, HasSubstr("'" + name + "'")) << path << ' ' << body;
      }
  }
}

TEST_F(BadRequestTest, APathMayNameAnything) {
  for (const auto& path : described_paths("get"))
    for (const auto& name : {std::string(300, 'a'), std::string(5000, 'a'), std::string("%00"),
                             std::string("%ff%fe"), std::string("%"), std::string("..%2f..%2f"),
                             std::string("%27%3B--"), std::string("a%0d%0aX-Y:%20z")})
      EXPECT_LT(get(filled(path, name)).status, 500U) << path << ' ' << name.substr(0, 20);
}

}  // namespace
}  // namespace galilean::monitor
