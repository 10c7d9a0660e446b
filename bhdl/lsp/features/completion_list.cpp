// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/completion_list.h"

namespace galilean::bhdl::lsp {
namespace {

constexpr int kSnippetFormat = 2;
constexpr std::size_t kOrderDigits = 6;

// Editors sort by this text and ignore the order of the list.
std::string order_text(std::size_t number) {
  const std::string digits = std::to_string(number);
  return std::string(kOrderDigits - std::min(kOrderDigits, digits.size()), '0') + digits;
}

}  // namespace

void CompletionList::add(const Proposal& proposal) {
  const bool snippet = session_.client.snippets && !proposal.snippet.empty();
  const std::string& plain = proposal.text.empty() ? proposal.label : proposal.text;
  const std::string& text = snippet ? proposal.snippet : plain;
  Json item{{"label", proposal.label},
            {"kind", static_cast<int>(proposal.kind)},
            {"sortText", order_text(items_.size())}};
  if (!proposal.detail.empty()) item["detail"] = proposal.detail;
  if (!proposal.help.empty()) item["documentation"] = proposal.help;
  if (snippet) item["insertTextFormat"] = kSnippetFormat;
  if (!session_.client.completion_defaults)
    item["textEdit"] = {{"range", range_}, {"newText", text}};
  else if (text != proposal.label)
    item["textEditText"] = text;
  items_.push_back(std::move(item));
}

Json CompletionList::result() && {
  Json list{{"isIncomplete", false}, {"items", std::move(items_)}};
  if (session_.client.completion_defaults) list["itemDefaults"] = {{"editRange", range_}};
  return list;
}

}  // namespace galilean::bhdl::lsp
