// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bhdl/lsp/server.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl::lsp {

/// Texts by their paths.
using Files = std::map<std::string, std::string>;

/// A folder of programs in memory.
class MemoryFolder : public ProgramFolder {
 public:
  explicit MemoryFolder(Files files) : files_(std::move(files)) {}
  [[nodiscard]] Result<std::string, ReadFailure> read(const std::string& path,
                                                      std::size_t most_bytes) const override;
  [[nodiscard]] std::vector<std::string> beside(const std::string& path) const override;

 private:
  Files files_;
};

/// A text with a cursor. In the marked text, the cursor is written as one `|`.
struct Marked {
  std::string text;
  TextPosition cursor;
};
[[nodiscard]] Marked marked(std::string text);

/// An editor in front of the server. It opens texts, makes requests, and keeps the diagnostics that
/// the server publishes.
class Editor {
 public:
  explicit Editor(Files files = {}, Json capabilities = {},
                  const Catalog& catalog = small_catalog());

  /// Opens `/name` and moves the cursor to its `|`, if it has one.
  void open(const std::string& name, const std::string& text);
  void change(const std::string& name, const Json& changes);
  void close(const std::string& name);

  /// Makes a request at the cursor of the file opened last, with `more` params. Returns its result.
  [[nodiscard]] Json ask(const std::string& method, const Json& more = Json::object());
  /// Makes the same request where an error is expected. Returns the error's message.
  [[nodiscard]] std::string refusal(const std::string& method, const Json& more = Json::object());
  /// Returns the whole answer to a message.
  [[nodiscard]] Json send(const Json& message);
  void notify(const std::string& method, const Json& params);

  /// Returns the diagnostics that are published for `/name`, one a line, as
  /// `line:character-line:character code`.
  [[nodiscard]] std::string problems(const std::string& name);
  [[nodiscard]] Json published(const std::string& name);
  [[nodiscard]] std::vector<std::string> completions();

  [[nodiscard]] Server& server() noexcept { return server_; }
  [[nodiscard]] const Json& initialized() const noexcept { return initialized_; }

 private:
  void take(const std::vector<std::string>& messages);

  Server server_;
  Json initialized_;
  std::map<std::string, Json> published_;
  std::string uri_;
  TextPosition cursor_;
  int next_id_ = 1;
};

/// Returns the text after a response's TextEdits.
[[nodiscard]] std::string edited(const std::string& text, const Json& edits);

}  // namespace galilean::bhdl::lsp
