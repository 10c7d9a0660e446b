// SPDX-License-Identifier: BSD-3-Clause
// Sends random bytes as a client of the monitor's HTTP port does, and then no more. The server must
// close the connection in the end. What reaches a handler was admitted and has the right that its
// token gives, and nothing that a client sends ends up as a line in the head of an answer.
#include <algorithm>
#include <memory>
#include <span>
#include <string>

#include "monitor/server/http/byte_range.h"
#include "monitor/server/http/http_caching.h"
#include "monitor/server/http/page_files.h"
#include "monitor/server/text/url_text.h"
#include "tests/fuzz/served_connection.h"

namespace {

using namespace galilean::monitor;
using galilean::bhdl::must;

void check_range(const HttpRequest& request) {
  for (const std::uint64_t size : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1000}}) {
    const auto range = byte_range(request.range, size);
    if (range.kind != ByteRange::Kind::kPart) continue;
    must(range.bytes > 0 && range.offset < size && range.bytes <= size - range.offset,
         "a part is in its file");
  }
}

void check(const HttpRequest& request) {
  static const Guard guard("127.0.0.1", {});
  must(guard.admit(request).ok(), "what the guard refuses reaches no handler");
  must((request.right == Right::kOperate) == (request.token == "operator"),
       "a request has the right that its token gives");
  must(!request.method.empty(), "a request has a method");
  must(percent_decoded(request.path).size() <= request.path.size(),
       "decoding makes nothing longer");
  check_range(request);
}

/// Reads what is left of a body, and then answers.
void take_rest(const std::shared_ptr<IncomingBody>& body, const Respond& respond) {
  body->next([body, respond](galilean::Result<std::span<const std::uint8_t>> piece) {
    if (piece && !piece.value().empty()) return take_rest(body, respond);
    respond(text_response("taken\n", "text/plain"));
  });
}

void answer(const HttpRequest& request, const Respond& respond) {
  static const PageFiles page("/nonexistent");
  check(request);
  if (request.body_stream) return take_rest(request.body_stream, respond);
  if (request.method == "POST") return respond(problem(400, request.body.substr(0, 100)));
  if (!page.has(request.path)) return respond(problem(404, "There is no " + request.path + "."));
  respond(with_caching_and_compression(page.get(request), request));
}

bool is_name_letter(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '-';
}

/// Requires that each line of the first answer's head is a field of this server.
void check_head(std::string_view answers) {
  const auto end = answers.find("\r\n\r\n");
  must(end != answers.npos, "an answer has a whole head");
  std::string_view head = answers.substr(0, end + 2);
  must(head.starts_with("HTTP/1."), "an answer says what it is");
  head.remove_prefix(head.find("\r\n") + 2);
  while (!head.empty()) {
    const auto line = head.substr(0, head.find("\r\n"));
    const auto colon = line.find(": ");
    must(colon != line.npos && colon > 0 &&
             std::ranges::all_of(line.substr(0, colon), is_name_letter),
         "each line of a head is a field");
    must(line.find_first_of("\r\n") == line.npos && line.find('\0') == line.npos,
         "a field is one line");
    head.remove_prefix(line.size() + 2);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static FuzzedServer server(answer);
  const auto answers = server.exchange({reinterpret_cast<const char*>(data), size});
  if (!answers.empty()) check_head(answers);
  return 0;
}
