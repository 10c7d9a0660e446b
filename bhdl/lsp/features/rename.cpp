// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/rename.h"

#include <algorithm>

#include "bhdl/check.h"
#include "bhdl/lsp/documents/name_search.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl::lsp {
namespace {

/// The workspace as it would be after the renaming.
class Renamed : public SourceProvider {
 public:
  explicit Renamed(const Workspace& workspace) : workspace_(workspace) {}

  std::map<std::string, std::string> texts;

  [[nodiscard]] Result<std::string, ReadFailure> read(const std::string& path,
                                                      std::size_t most_bytes) const override {
    const auto found = texts.find(path);
    if (found == texts.end()) return workspace_.read(path, most_bytes);
    if (found->second.size() > most_bytes) return too_large(path, found->second.size(), most_bytes);
    return found->second;
  }
  [[nodiscard]] std::string shown(const std::string& path) const override { return path; }

 private:
  const Workspace& workspace_;
};

bool is_word(std::string_view text) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return !text.empty() && letter(text.front()) &&
         std::ranges::all_of(text, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

bool fits_in_quotes(std::string_view text) {
  constexpr std::array<std::string_view, 7> kEnds{"\"", "“", "”", "„", "‟", "\n", "\r"};
  return !text.empty() && !find_bad_text(text) && std::ranges::none_of(kEnds, [&](auto end) {
    return text.find(end) != std::string_view::npos;
  });
}

void refuse_unreadable(const Name& name, const std::string& new_text) {
  const bool constant = name.space == NameSpace::kConstant;
  if (constant ? is_word(new_text) : fits_in_quotes(new_text)) return;
  throw Refusal(RpcError::kInvalidParams,
                in_quotes(new_text) + " cannot be a name: " +
                    (constant ? "a constant's name consists of letters, digits and _, and does not "
                                "begin with a digit"
                              : "it needs a character, and has no quotes and no line ends"));
}

void refuse_taken(const Session& session, const std::vector<Occurrence>& places,
                  const Name& new_name) {
  for (const auto& place : places)
    for (const auto& other : declarations(session.workspace, place.file->path, new_name)) {
      const auto at = other.file->index.position(other.range.begin, PositionEncoding::kUtf32);
      throw Refusal(RpcError::kRequestFailed,
                    "there is a " + std::string(in_words(new_name.space)) + " " +
                        in_quotes(new_name.text) + " already: it is at " + other.file->path + ":" +
                        std::to_string(at.line + 1) + ":" + std::to_string(at.character + 1));
    }
}

Renamed apply(const Session& session, const std::vector<Occurrence>& places,
              const std::string& new_text) {
  Renamed result(session.workspace);
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    auto& text = result.texts.try_emplace(place->file->path, place->file->text).first->second;
    text.replace(place->range.begin, place->range.end - place->range.begin, new_text);
  }
  return result;
}

// Renaming may break a program: a default may give the old name, or the name stands where it was
// not recognised.
void refuse_breaking(const Session& session, const Renamed& renamed) {
  for (const auto& touched : renamed.texts)
    for (const auto& program : session.workspace.programs_with(touched.first)) {
      const std::string& main_path = program.front()->path;
      if (any_error(check(main_path, session.workspace, session.vocabulary).diagnostics)) continue;
      for (const auto& each : check(main_path, renamed, session.vocabulary).diagnostics)
        if (each.severity == Severity::kError)
          throw Refusal(RpcError::kRequestFailed,
                        "the program would be wrong with that name: " + format(each));
    }
}

NameAt declared_name(const Session& session, const ParsedFile& file, std::size_t offset) {
  const auto name = name_at(session.workspace, file, offset);
  if (!name || declarations(session.workspace, file.path, name->name).empty())
    throw Refusal(RpcError::kRequestFailed,
                  "here is no name that the program declares: put the cursor on one");
  return *name;
}

}  // namespace

Json prepare_rename(const Session& session, const Json& params) {
  const FilePointer file = session.file(params);
  const auto name = name_at(session.workspace, *file, session.offset(*file, params));
  if (!name || declarations(session.workspace, file->path, name->name).empty()) return nullptr;
  return {{"range", session.range(*file, name->range)}, {"placeholder", name->name.text}};
}

Json rename(const Session& session, const Json& params) {
  const FilePointer file = session.file(params);
  const auto new_text = params.at("newName").get<std::string>();
  const NameAt old = declared_name(session, *file, session.offset(*file, params));
  if (new_text == old.name.text) return workspace_edit(session, {});
  refuse_unreadable(old.name, new_text);
  const auto places = occurrences(session.workspace, file->path, old.name);
  refuse_taken(session, places, {old.name.space, new_text});
  refuse_breaking(session, apply(session, places, new_text));
  std::map<std::string, Json> edits;
  for (const auto& place : places)
    edits[place.file->path].push_back(
        {{"range", session.range(*place.file, place.range)}, {"newText", new_text}});
  return workspace_edit(session, edits);
}

}  // namespace galilean::bhdl::lsp
