// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/untyped_topic.h"

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/q_misc.h>
#include <dds/ddsi/q_protocol.h>
#include <dds/ddsi/q_radmin.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

#include "core/wire/participant.h"
#include "core/wire/security.h"

namespace galilean::wire {
namespace {

/// A message as it came: with its header, in the byte order of its writer.
struct UntypedMessage : ddsi_serdata {
  std::vector<std::uint8_t> bytes;
  std::uint64_t sequence = 0;

  UntypedMessage(const ddsi_sertype* of_type, ddsi_serdata_kind of_kind) : ddsi_serdata() {
    ddsi_serdata_init(this, of_type, of_kind);
    hash = of_type->serdata_basehash;
  }
  static const UntypedMessage& of(const ddsi_serdata* data) {
    return *static_cast<const UntypedMessage*>(data);
  }
};

/// Cyclone has turned the header of the packet into this machine's byte order.
std::uint64_t sequence_in_packet(const nn_rdata& first) {
  Data_DataFrag_common_t header;
  std::memcpy(&header, NN_RMSG_PAYLOADOFF(first.rmsg, NN_RDATA_SUBMSG_OFF(&first)), sizeof header);
  return fromSN(header.writerSN);
}

ddsi_serdata* from_fragments(const ddsi_sertype* type, ddsi_serdata_kind kind,
                             const nn_rdata* fragment, std::size_t size) {
  auto* message = new UntypedMessage(type, kind);
  message->bytes.reserve(size);
  message->sequence = sequence_in_packet(*fragment);
  for (; fragment; fragment = fragment->nextfrag) {
    const std::size_t had = message->bytes.size();
    if (fragment->maxp1 <= had) continue;  // fragments may overlap
    const auto* first = NN_RMSG_PAYLOADOFF(fragment->rmsg, NN_RDATA_PAYLOAD_OFF(fragment));
    message->bytes.insert(message->bytes.end(), first + (had - fragment->min),
                          first + (fragment->maxp1 - fragment->min));
  }
  return message;
}

ddsi_serdata* from_parts(const ddsi_sertype* type, ddsi_serdata_kind kind, ddsrt_msg_iovlen_t count,
                         const ddsrt_iovec_t* parts, std::size_t) {
  auto* message = new UntypedMessage(type, kind);
  for (const auto& part : std::span(parts, count)) {
    const auto* first = static_cast<const std::uint8_t*>(part.iov_base);
    message->bytes.insert(message->bytes.end(), first, first + part.iov_len);
  }
  return message;
}

/// What Cyclone asks of messages. None is ever written, nor turned into a C struct.
constexpr ddsi_serdata_ops kMessageOperations{
    .eqkey = [](const ddsi_serdata*, const ddsi_serdata*) { return true; },
    .get_size =
        [](const ddsi_serdata* data) {
          return static_cast<std::uint32_t>(UntypedMessage::of(data).bytes.size());
        },
    .from_ser = from_fragments,
    .from_ser_iov = from_parts,
    .from_keyhash = [](const ddsi_sertype* type, const ddsi_keyhash*) -> ddsi_serdata* {
      return new UntypedMessage(type, SDK_KEY);
    },
    .from_sample = [](const ddsi_sertype*, ddsi_serdata_kind, const void*) -> ddsi_serdata* {
      return nullptr;
    },
    .to_ser =
        [](const ddsi_serdata* data, std::size_t offset, std::size_t size, void* to) {
          const auto& bytes = UntypedMessage::of(data).bytes;
          std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), size,
                      static_cast<std::uint8_t*>(to));
        },
    .to_ser_ref = [](const ddsi_serdata* data, std::size_t offset, std::size_t size,
                     ddsrt_iovec_t* part) -> ddsi_serdata* {
      part->iov_base = const_cast<std::uint8_t*>(UntypedMessage::of(data).bytes.data() + offset);
      part->iov_len = size;
      return ddsi_serdata_ref(data);
    },
    .to_ser_unref = [](ddsi_serdata* data, const ddsrt_iovec_t*) { ddsi_serdata_unref(data); },
    .to_sample = [](const ddsi_serdata*, void*, void**, void*) { return false; },
    // Cyclone keeps this one for longer than the topic.
    .to_untyped = [](const ddsi_serdata* data) -> ddsi_serdata* {
      auto* key = new UntypedMessage(data->type, SDK_KEY);
      key->type = nullptr;
      return key;
    },
    .untyped_to_sample = [](const ddsi_sertype*, const ddsi_serdata*, void*, void**,
                            void*) { return false; },
    .free = [](ddsi_serdata* data) { delete static_cast<UntypedMessage*>(data); },
    .print = [](const ddsi_sertype*, const ddsi_serdata*, char* text,
                std::size_t size) -> std::size_t {
      if (size > 0) *text = 0;
      return 0;
    },
    .get_keyhash = [](const ddsi_serdata*, ddsi_keyhash* key, bool) { *key = {}; }};

constexpr ddsi_sertype_ops kTypeOperations{
    .version = ddsi_sertype_v0,
    .free =
        [](ddsi_sertype* type) {
          ddsi_sertype_fini(type);
          delete type;
        },
    .zero_samples = [](const ddsi_sertype*, void*, std::size_t) {},
    .realloc_samples = [](void** samples, const ddsi_sertype*, void*, std::size_t,
                          std::size_t count) { std::fill_n(samples, count, nullptr); },
    .free_samples = [](const ddsi_sertype*, void**, std::size_t, dds_free_op_t) {},
    .equal = [](const ddsi_sertype*, const ddsi_sertype*) { return true; },
    .hash = [](const ddsi_sertype*) -> std::uint32_t { return 0; }};

}  // namespace

Entity make_untyped_topic(const Participant& participant, const UntypedTopic& topic) {
  auto* type = new ddsi_sertype{};
  ddsi_sertype_init(type, topic.dds_type.c_str(), &kTypeOperations, &kMessageOperations,
                    !topic.keyed);
  const auto handle = dds_create_topic_sertype(participant.handle(), topic.name.c_str(), &type,
                                               nullptr, nullptr, nullptr);
  if (handle < 0) ddsi_sertype_unref(type);
  return Entity(permitted(handle, "use topic", topic.name));
}

std::uint64_t sequence_of(const ddsi_serdata& message) noexcept {
  return message.ops == &kMessageOperations ? UntypedMessage::of(&message).sequence : 0;
}

}  // namespace galilean::wire
