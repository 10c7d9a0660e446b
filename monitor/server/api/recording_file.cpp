// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/recording_file.h"

#include <string>

#include "monitor/server/http/byte_range.h"
#include "monitor/server/http/http_caching.h"

namespace galilean::monitor {
namespace {

/// Another content has another size, another time or another place on the disk.
std::string etag_of(const OpenedRecording& recording) {
  return '"' + std::to_string(recording.inode) + '-' + std::to_string(recording.bytes) + '-' +
         std::to_string(recording.modified_ns) + '"';
}

void describe_part(const ByteRange& range, std::uint64_t size, HttpResponse& response) {
  const auto last = range.offset + range.bytes - 1;
  response.status = 206;
  response.headers.emplace_back("Content-Range", "bytes " + std::to_string(range.offset) + '-' +
                                                     std::to_string(last) + '/' +
                                                     std::to_string(size));
}

HttpResponse out_of_bounds(std::uint64_t size) {
  auto response = problem(416, "The recording has only " + std::to_string(size) + " bytes.");
  response.headers.emplace_back("Content-Range", "bytes */" + std::to_string(size));
  return response;
}

/// A page of another site may read these fields as well.
void add_common_fields(const std::string& etag, HttpResponse& response) {
  response.headers.insert(
      response.headers.end(),
      {{"Accept-Ranges", "bytes"},
       {"ETag", etag},
       {"Cache-Control", "no-cache"},
       {"Access-Control-Expose-Headers", "Accept-Ranges, Content-Length, Content-Range, ETag"}});
}

}  // namespace

HttpResponse recording_response(const OpenedRecording& recording, const HttpRequest& request) {
  const auto etag = etag_of(recording);
  HttpResponse response{.status = 200, .content_type = "application/octet-stream"};
  if (is_known(request.if_none_match, etag)) {
    response.status = 304;
    add_common_fields(etag, response);
    return response;
  }
  // A part of another content than the client has a part of would not fit.
  const bool fits = request.if_range.empty() || request.if_range == etag;
  const bool asks_for_part = request.method == "GET" && fits;
  auto range = asks_for_part ? byte_range(request.range, recording.bytes) : ByteRange{};
  if (range.kind == ByteRange::Kind::kOutOfBounds) {
    response = out_of_bounds(recording.bytes);
  } else {
    if (range.kind == ByteRange::Kind::kPart)
      describe_part(range, recording.bytes, response);
    else
      range.bytes = recording.bytes;
    response.stream =
        StreamedBody{range.offset, range.bytes,
                     [source = recording.source](std::uint64_t offset, std::span<std::uint8_t> to) {
                       return source->read(offset, to);
                     }};
  }
  add_common_fields(etag, response);
  return response;
}

HttpResponse recording_problem(const NotOpened& why) {
  switch (why.why) {
    case NotOpened::Why::kNotThere:
    case NotOpened::Why::kNoFile:
      return problem(404, why.message);
    case NotOpened::Why::kForbidden:
      return problem(403, why.message);
    case NotOpened::Why::kUnreadable:
      break;
  }
  return problem(503, why.message);
}

}  // namespace galilean::monitor
