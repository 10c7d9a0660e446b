// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/diagnostic_publisher.h"

#include <algorithm>
#include <set>

#include "bhdl/source/text.h"
#include "bhdl/syntax/lexer.h"
#include "bhdl/syntax/lowering.h"

namespace galilean::bhdl::lsp {
namespace {

bool same(const Diagnostic& a, const Diagnostic& b) {
  return a.line == b.line && a.column == b.column && a.code == b.code && a.message == b.message;
}

void add_new(std::vector<Diagnostic>& all, const std::vector<Diagnostic>& more) {
  for (const auto& each : more)
    if (std::ranges::none_of(all, [&](const auto& known) { return same(known, each); }))
      all.push_back(each);
}

Json related_to_json(const Session& session, const Diagnostic& diagnostic) {
  Json related = Json::array();
  for (const auto& place : diagnostic.related) {
    const FilePointer file = session.workspace.file(place.at.file);
    if (file == nullptr) continue;
    const std::size_t at = file->index.offset_of_place(place.at.line, place.at.column);
    related.push_back(
        {{"location", session.location(*file, {at, at})}, {"message", place.message}});
  }
  return related;
}

/// Returns a reader that gives the trees that the workspace has. It parses the texts of other
/// files.
TreeReader reader_of(const ProgramFiles& files) {
  return [&files](const LoadedFile& wanted, Diagnostics& diagnostics) {
    const auto found =
        std::ranges::find(files, wanted.path, [](const FilePointer& file) { return file->path; });
    if (found == files.end() || !(*found)->is_readable || (*found)->text != wanted.text)
      return read_tree(wanted, diagnostics);
    diagnostics.add((*found)->reading.faults);
    return lowered((*found)->parse_tree, (*found)->path);
  };
}

Json params_for(const Session& session, const std::string& path,
                const std::vector<Diagnostic>& diagnostics) {
  Json params{{"uri", session.workspace.uri(path)}, {"diagnostics", Json::array()}};
  if (const auto* open = session.workspace.find_open(path)) params["version"] = open->version;
  const FilePointer file = session.workspace.file(path);
  const ParsedFile unreadable(path, "", session.vocabulary);
  for (const auto& each : diagnostics)
    params["diagnostics"].push_back(
        diagnostic_to_json(session, file == nullptr ? unreadable : *file, each));
  return params;
}

}  // namespace

ByteRange range_of(const ParsedFile& file, const Diagnostic& diagnostic) {
  const std::size_t begin = file.index.offset_of_place(diagnostic.line, diagnostic.column);
  if (!file.is_readable) return {begin, begin};
  Diagnostics unheard;
  const std::string_view rest = std::string_view(file.text).substr(begin);
  const Token token = Lexer("", rest, unheard).next();
  if (token.kind == TokenKind::kEndOfFile) return {begin, begin};
  std::size_t end = static_cast<std::size_t>(token.text.data() - rest.data()) + token.text.size();
  if (token.kind == TokenKind::kText)
    end += std::max<std::size_t>(1, character_size(rest.substr(std::min(end, rest.size()))));
  return {begin, std::min(begin + end, file.text.size())};
}

Json diagnostic_to_json(const Session& session, const ParsedFile& file,
                        const Diagnostic& diagnostic) {
  constexpr int kError = 1;
  constexpr int kWarning = 2;
  std::string message = diagnostic.message;
  if (!diagnostic.hint.empty()) message += "\n" + diagnostic.hint;
  Json json{{"range", session.range(file, range_of(file, diagnostic))},
            {"severity", diagnostic.severity == Severity::kError ? kError : kWarning},
            {"code", diagnostic.code},
            {"source", "bhdl"},
            {"message", std::move(message)}};
  if (!diagnostic.related.empty() && session.client.related_information)
    json["relatedInformation"] = related_to_json(session, diagnostic);
  return json;
}

const std::vector<Diagnostic>& DiagnosticPublisher::of(const std::string& path) const {
  static const std::vector<Diagnostic> none;
  const auto found = current_.find(path);
  return found == current_.end() ? none : found->second;
}

void DiagnosticPublisher::check_programs(const Session& session) {
  std::map<std::string, Checked> checked;
  for (const auto& [path, document] : session.workspace.open_documents())
    for (auto& files : session.workspace.programs_with(path)) {
      const std::string main_path = files.empty() ? path : files.front()->path;
      if (checked.contains(main_path)) continue;
      Checked& now = checked[main_path];
      if (const auto before = checked_.find(main_path);
          before != checked_.end() && !files.empty() && before->second.files == files) {
        now = std::move(before->second);
        continue;
      }
      now.files = std::move(files);
      for (auto& each :
           diagnose(main_path, session.workspace, reader_of(now.files), session.vocabulary))
        now.diagnostics[each.file].push_back(std::move(each));
    }
  checked_ = std::move(checked);
}

// A program whose main file is not open adds only what concerns the open files.
DiagnosticPublisher::OfPath DiagnosticPublisher::merged(const Session& session) const {
  OfPath all;
  for (const auto& open : session.workspace.open_documents()) all[open.first];
  for (const auto& [main_path, program] : checked_) {
    const bool open = session.workspace.find_open(main_path) != nullptr;
    for (const auto& [path, diagnostics] : program.diagnostics)
      if (open || session.workspace.find_open(path) != nullptr) add_new(all[path], diagnostics);
  }
  return all;
}

std::vector<Json> DiagnosticPublisher::publish(const Session& session) {
  due_ = false;
  check_programs(session);
  current_ = merged(session);
  for (const auto& before : published_) current_[before.first];
  std::vector<Json> notifications;
  std::map<std::string, std::string> published;
  for (const auto& [path, diagnostics] : current_) {
    Json params = params_for(session, path, diagnostics);
    std::string text = dumped(params);
    const auto before = published_.find(path);
    if (before == published_.end() || before->second != text)
      notifications.push_back(
          rpc_notification("textDocument/publishDiagnostics", std::move(params)));
    const bool worth_keeping = !diagnostics.empty() || session.workspace.find_open(path) != nullptr;
    if (worth_keeping) published.emplace(path, std::move(text));
  }
  published_ = std::move(published);
  return notifications;
}

}  // namespace galilean::bhdl::lsp
