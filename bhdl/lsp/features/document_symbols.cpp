// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/document_symbols.h"

#include "bhdl/lsp/documents/block.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl::lsp {
namespace {

/// The protocol's SymbolKind.
enum class SymbolKind {
  kModule = 2,
  kNamespace = 3,
  kClass = 5,
  kVariable = 13,
  kConstant = 14,
  kObject = 19,
  kEvent = 24
};

SymbolKind symbol_kind(const Block& block) {
  if (block.kind == BlockKind::kState) return SymbolKind::kEvent;
  if (block.kind != BlockKind::kComponent) return SymbolKind::kNamespace;
  if (block.components == ComponentKind::kVariable) return SymbolKind::kVariable;
  return is_device(block.components) ? SymbolKind::kObject : SymbolKind::kClass;
}

bool is_shown(const Block& block) {
  return block.kind != BlockKind::kSchemaList && block.kind != BlockKind::kCondition &&
         block.kind != BlockKind::kExpectStep;
}

class SymbolTree {
 public:
  SymbolTree(const Session& session, const ParsedFile& file) : session_(session), file_(file) {}

  Json of(const std::vector<Block>& blocks) {
    std::vector<std::vector<std::size_t>> children(blocks.size());
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < blocks.size(); ++i)
      if (is_shown(blocks[i]))
        (blocks[i].parent ? children[*blocks[i].parent] : roots).push_back(i);
    Json symbols = Json::array();
    for (const std::size_t root : roots) {
      Json symbol = symbol_of(blocks[root]);
      for (const std::size_t child : children[root])
        add_child(symbol, blocks[root], symbol_of(blocks[child]));
      if (blocks[root].kind == BlockKind::kDefine) add_constants(symbol, blocks[root]);
      symbols.push_back(std::move(symbol));
      for (auto& each : flat_) symbols.push_back(std::move(each));
      flat_.clear();
    }
    return symbols;
  }

 private:
  Json symbol_of(const Block& block) const {
    const std::string_view name = block.name.empty() ? block.word : block.name;
    return symbol(name, block.name.empty() ? std::string_view() : block.word, symbol_kind(block),
                  block.range);
  }

  Json symbol(std::string_view name, std::string_view detail, SymbolKind kind,
              ByteRange range) const {
    Json json{{"name", name}, {"kind", static_cast<int>(kind)}};
    if (!session_.client.symbol_trees) {
      json["location"] = session_.location(file_, range);
      return json;
    }
    if (!detail.empty()) json["detail"] = detail;
    json["range"] = session_.range(file_, range);
    json["selectionRange"] = session_.range(file_, file_.index.range_of(name));
    return json;
  }

  void add_child(Json& parent, const Block& block, Json child) {
    if (session_.client.symbol_trees) {
      parent["children"].push_back(std::move(child));
      return;
    }
    child["containerName"] = block.word;
    flat_.push_back(std::move(child));
  }

  void add_constants(Json& parent, const Block& define) {
    for (const auto& mention : file_.mentions().names) {
      const ByteRange range = file_.index.range_of(mention.name);
      const bool here = define.range.begin <= range.begin && range.end <= define.range.end;
      if (here && mention.declares && mention.space == NameSpace::kConstant)
        add_child(parent, define, symbol(mention.name, {}, SymbolKind::kConstant, range));
    }
  }

  const Session& session_;
  const ParsedFile& file_;
  std::vector<Json> flat_;
};

void fold_comments(const TextIndex& index, Json& folds) {
  for (std::size_t first = 0; first < index.line_count(); ++first) {
    std::size_t last = first;
    while (last < index.line_count() && index.is_comment_line(last)) ++last;
    if (last > first + 1)
      folds.push_back({{"startLine", first}, {"endLine", last - 1}, {"kind", "comment"}});
    first = std::max(first, last);
  }
}

}  // namespace

Json document_symbols(const Session& session, const Json& params) {
  const FilePointer file = session.file(params);
  if (!file->is_readable) return Json::array();
  return SymbolTree(session, *file).of(blocks_of(file->parse_tree));
}

Json folding_ranges(const Session& session, const Json& params) {
  const FilePointer file = session.file(params);
  Json folds = Json::array();
  if (!file->is_readable) return folds;
  for (const auto& block : blocks_of(file->parse_tree)) {
    const std::size_t first = file->index.line_of(block.range.begin);
    const std::size_t last = file->index.line_of(block.range.end);
    if (last > first) folds.push_back({{"startLine", first}, {"endLine", last}});
  }
  fold_comments(file->index, folds);
  return folds;
}

}  // namespace galilean::bhdl::lsp
