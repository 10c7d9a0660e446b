// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/hover.h"

#include "bhdl/check/describe.h"
#include "bhdl/lsp/documents/block.h"
#include "bhdl/lsp/documents/name_search.h"
#include "bhdl/lsp/documents/spot.h"
#include "bhdl/lsp/features/bit_meaning.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl::lsp {
namespace {

std::string component_text(const ComponentSpec& spec, bool of_catalog) {
  std::string text = "**" + spec.name + "**";
  if (of_catalog) text += ", " + std::string(kind_in_words(spec.kind));
  text += "\n\n" + spec.help + "\n";
  for (const auto& attribute : spec.attributes)
    text += "\n- `" + attribute.name + "`: " + facts_in_words(attribute) + ". " + attribute.help;
  return text + "\n";
}

std::string attribute_text(const ComponentSpec& component, const AttributeSpec& spec) {
  return "**" + spec.name + "** of " + component.name + "\n\n" + facts_in_words(spec) + "\n\n" +
         spec.help + "\n";
}

/// Returns the whole lines that declare a name, with the comments beside them and directly above.
std::string declaration_lines(const Occurrence& declared) {
  constexpr std::size_t kMostLines = 12;
  const ParsedFile& file = *declared.file;
  ByteRange range = declared.range;
  for (const auto& block : blocks_of(file.parse_tree))
    if (!block.name.empty() && file.index.range_of(block.name).begin == declared.range.begin)
      range = block.range;
  std::size_t first = file.index.line_of(range.begin);
  const std::size_t last = file.index.line_of(range.end);
  while (first > 0 && file.index.is_comment_line(first - 1)) --first;
  std::string lines;
  for (std::size_t line = first; line <= last; ++line) {
    if (line - first == kMostLines) return lines + "…\n";
    lines.append(file.index.line(line)).append("\n");
  }
  return lines;
}

/// Returns a block of Markdown code. Its fence is longer than any in the text, so that the text
/// cannot end it.
std::string code(const std::string& text) {
  std::string fence = "```";
  while (text.find(fence) != std::string::npos) fence += '`';
  return fence + "bhdl\n" + text + fence + "\n";
}

// Names of a program must not become markup.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("\\`*<>[]&").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string name_text(const Session& session, const std::string& path, const Name& name) {
  std::string text;
  for (const auto& declared : declarations(session.workspace, path, name)) {
    const std::string type = declared.type.empty() ? "" : ", " + std::string(declared.type);
    const auto line = std::to_string(declared.file->index.line_of(declared.range.begin) + 1);
    text += "**" + escaped(name.text) + "**, " + std::string(in_words(name.space)) + type + "\n\n" +
            code(declaration_lines(declared)) +
            std::filesystem::path(declared.file->path).filename().string() + ":" + line + "\n\n";
  }
  return text;
}

std::string bit_text(const Session& session, const std::string& path, const BitAt& bit) {
  return "**bit " + std::to_string(bit.index) + "** of " + escaped(in_quotes(bit.variable)) +
         "\n\n" + writers_in_words(session, path, bit) + "\n" +
         name_text(session, path, {NameSpace::kVariable, bit.variable});
}

std::string plain(std::string markdown) {
  std::erase_if(markdown, [](char c) { return c == '*' || c == '`' || c == '\\'; });
  return markdown;
}

Json answer(const Session& session, const ParsedFile& file, ByteRange range,
            const std::string& text) {
  const bool markdown = session.client.markdown;
  return {
      {"contents",
       {{"kind", markdown ? "markdown" : "plaintext"}, {"value", markdown ? text : plain(text)}}},
      {"range", session.range(file, range)}};
}

}  // namespace

Json hover(const Session& session, const Json& params) {
  const FilePointer file = session.file(params);
  const std::size_t offset = session.offset(*file, params);
  if (const auto name = name_at(session.workspace, *file, offset)) {
    const std::string text = name_text(session, file->path, name->name);
    if (!text.empty()) return answer(session, *file, name->range, text);
  }
  const auto spot = spot_at(*file, session.vocabulary, offset);
  if (!spot) return nullptr;
  if (const auto bit = bit_at(*spot); bit && spot->value != nullptr)
    return answer(session, *file, spot->range, bit_text(session, file->path, *bit));
  const bool of_catalog = session.vocabulary.find(spot->component->name) == spot->component;
  return answer(session, *file, spot->range,
                spot->attribute == nullptr ? component_text(*spot->component, of_catalog)
                                           : attribute_text(*spot->component, *spot->attribute));
}

}  // namespace galilean::bhdl::lsp
