// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/program_texts.h"

#include <functional>
#include <utility>

#include "core/visible_text.h"
#include "core/wire/messages.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

/// The files of a message, with the program's hash before their names.
template <class Message>
std::vector<ProgramTexts::Text> texts_in(std::span<const std::uint8_t> cdr) {
  Message message;
  if (!msg::decode_cdr(cdr, message)) return {};
  std::vector<ProgramTexts::Text> texts;
  for (auto& file : message.files)
    texts.push_back({visible(message.hash) + "/" + visible(file.path), std::move(file.text)});
  return texts;
}

std::vector<ProgramTexts::Text> all_texts(const std::string& ros_type,
                                          std::span<const std::uint8_t> cdr) {
  if (ros_type == msg::Program::kRosType) return texts_in<msg::Program>(cdr);
  if (ros_type == msg::ProgramPush::kRosType) return texts_in<msg::ProgramPush>(cdr);
  return {};
}

}  // namespace

std::vector<ProgramTexts::Text> ProgramTexts::find(const wire::EndpointInfo& writer,
                                                   const wire::Received& received) {
  auto texts = all_texts(shown_type(writer.dds_type), received.cdr);
  std::erase_if(texts, [this](const Text& each) {
    return !found_.emplace(each.name, std::hash<std::string>()(each.text)).second;
  });
  return texts;
}

}  // namespace galilean::monitor
