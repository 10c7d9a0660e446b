// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/quick_fix.h"

#include <algorithm>

#include "bhdl/source/names.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl::lsp {
namespace {

constexpr std::string_view kQuickFix = "quickfix";

bool wants_fixes(const Json& params) {
  const Json* only = find_in(params, Json::json_pointer("/context/only"));
  return only == nullptr || !only->is_array() ||
         std::ranges::any_of(*only, [](const Json& kind) { return kind == kQuickFix; });
}

ByteRange without_quotes(const ParsedFile& file, ByteRange range) {
  const std::string_view text = std::string_view(file.text).substr(range.begin);
  const bool quoted = !text.empty() && text.front() != '_' &&
                      std::isalnum(static_cast<unsigned char>(text.front())) == 0;
  if (!quoted || range.end - range.begin < 2) return range;
  std::size_t last = range.end - 1;
  while (last > range.begin && (static_cast<unsigned char>(file.text[last]) & 0xC0) == 0x80) --last;
  return {range.begin + character_size(text), last};
}

// Where a constant stood for the misspelt name, the mistake is in its definition and not here.
bool is_misspelling(std::string_view written, const std::string& meant) {
  const int most = std::max(tolerance(written), tolerance(meant));
  return written != meant && edit_distance(written, meant, most) <= most;
}

}  // namespace

Json quick_fixes(const Session& session, const DiagnosticPublisher& publisher, const Json& params) {
  const FilePointer file = session.file(params);
  const ByteRange wanted = session.bytes(*file, params.at("range"));
  Json actions = Json::array();
  if (!wants_fixes(params)) return actions;
  for (const auto& each : publisher.of(file->path)) {
    const ByteRange whole = range_of(*file, each);
    if (each.replacement.empty() || whole.end < wanted.begin || wanted.end < whole.begin) continue;
    const ByteRange range = without_quotes(*file, whole);
    const auto written = std::string_view(file->text).substr(range.begin, range.end - range.begin);
    if (!is_misspelling(written, each.replacement)) continue;
    const Json edit{{"range", session.range(*file, range)}, {"newText", each.replacement}};
    actions.push_back({{"title", "Change to " + in_quotes(each.replacement)},
                       {"kind", kQuickFix},
                       {"isPreferred", true},
                       {"diagnostics", Json::array({diagnostic_to_json(session, *file, each)})},
                       {"edit", workspace_edit(session, {{file->path, Json::array({edit})}})}});
  }
  return actions;
}

}  // namespace galilean::bhdl::lsp
