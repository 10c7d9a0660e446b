// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "bhdl/lsp/protocol/session.h"

namespace galilean::bhdl::lsp {

/// The protocol's CompletionItemKind.
enum class ItemKind {
  kField = 5,
  kVariable = 6,
  kClass = 7,
  kModule = 9,
  kUnit = 11,
  kValue = 12,
  kKeyword = 14,
  kFile = 17,
  kEnumMember = 20,
  kConstant = 21,
  kEvent = 23
};

/// One proposal.
struct Proposal {
  std::string label;
  ItemKind kind = ItemKind::kValue;
  std::string detail = {};
  std::string help = {};
  std::string text = {};     ///< the text that is inserted; empty: the label
  std::string snippet = {};  ///< the text with places to fill in, for a client that supports them
};

/// Collects proposals for one place, in the order in which they are added.
class CompletionList {
 public:
  /// `range` is what a proposal replaces.
  CompletionList(const Session& session, Json range)
      : session_(session), range_(std::move(range)) {}

  void add(const Proposal& proposal);
  [[nodiscard]] Json result() &&;

 private:
  const Session& session_;
  Json range_;
  Json items_ = Json::array();
};

}  // namespace galilean::bhdl::lsp
