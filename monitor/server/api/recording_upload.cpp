// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/recording_upload.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "monitor/recordings/upload.h"

namespace galilean::monitor {
namespace {

int status_of(NotKept::Why why) {
  switch (why) {
    case NotKept::Why::kNoName:
      return 400;
    case NotKept::Why::kExists:
      return 409;
    case NotKept::Why::kTooLarge:
      return 413;
    case NotKept::Why::kNoRecording:
      return 422;
    case NotKept::Why::kNoRoom:
      return 507;
    case NotKept::Why::kUnwritable:
      break;
  }
  return 503;
}

/// One upload: reads a piece from the client, writes it on the worker, and reads the next.
class ReceivedRecording : public std::enable_shared_from_this<ReceivedRecording> {
 public:
  ReceivedRecording(Worker& worker, std::string name, const HttpRequest& request, Respond respond)
      : worker_(worker),
        name_(std::move(name)),
        body_(request.body_stream),
        respond_(std::move(respond)) {}

  void begin(const RecordingFolder& folder, std::optional<std::uint64_t> bytes) {
    worker_.run([&folder, name = name_, bytes] { return Upload::begin(folder, name, bytes, {}); },
                [self = shared_from_this()](Result<Upload, NotKept> begun) {
                  if (!begun) return self->refuse(begun.error());
                  self->upload_ = std::make_shared<Upload>(std::move(begun).value());
                  self->next();
                },
                on_failure());
  }

 private:
  void next() {
    body_->next([self = shared_from_this()](const Result<std::span<const std::uint8_t>>& piece) {
      if (!piece) return self->drop();
      if (piece.value().empty()) return self->finish();
      self->append(piece.value());
    });
  }

  void append(std::span<const std::uint8_t> piece) {
    worker_.run([upload = upload_, piece] { return upload->append(piece); },
                [self = shared_from_this()](const Upload::Kept& done) {
                  if (!done) return self->refuse(done.error());
                  self->next();
                },
                on_failure());
  }

  void finish() {
    worker_.run([upload = upload_] { return upload->finish(); },
                [self = shared_from_this()](const Result<KeptRecording, NotKept>& done) {
                  if (!done) return self->refuse(done.error());
                  self->answer(done.value());
                },
                on_failure());
  }

  void answer(const KeptRecording& kept) {
    nlohmann::json json{{"name", name_}, {"complete", kept.complete}};
    if (!kept.note.empty()) json["note"] = kept.note;
    respond_(json_response(json, 201));
  }

  void refuse(const NotKept& why) {
    drop();
    respond_(problem(status_of(why.why), why.message));
  }

  /// Removes the draft, on the worker.
  void drop() {
    worker_.run([upload = std::exchange(upload_, nullptr)]() mutable { upload.reset(); });
  }

  [[nodiscard]] std::function<void(const std::string&)> on_failure() {
    return [self = shared_from_this()](const std::string& why) {
      self->refuse({NotKept::Why::kUnwritable, "The monitor cannot do this now: " + why + "."});
    };
  }

  Worker& worker_;
  std::string name_;
  std::shared_ptr<IncomingBody> body_;
  Respond respond_;
  std::shared_ptr<Upload> upload_;
};

}  // namespace

void receive_recording(const RecordingFolder& folder, Worker& worker, const std::string& name,
                       const HttpRequest& request, const Respond& respond) {
  std::make_shared<ReceivedRecording>(worker, name, request, respond)
      ->begin(folder, request.body_bytes);
}

}  // namespace galilean::monitor
