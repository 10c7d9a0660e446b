// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bhdl/lsp/documents/parsed_file.h"
#include "bhdl/lsp/documents/program_folder.h"

namespace galilean::bhdl::lsp {

/// A program's files, the main file first.
using ProgramFiles = std::vector<FilePointer>;

/// The editor's open documents, and behind them the files of the folder. Files are known by their
/// paths.
class Workspace : public SourceProvider {
 public:
  struct Document {
    std::string uri;  ///< as the client spells it
    std::int64_t version = 0;
    std::string text;
  };

  Workspace(const ProgramFolder& folder, const Vocabulary& vocabulary)
      : folder_(folder), vocabulary_(vocabulary) {}

  void open(const std::string& path, Document document) { open_[path] = std::move(document); }
  void close(const std::string& path) { open_.erase(path); }
  /// Returns nullptr if the file is not open.
  [[nodiscard]] Document* find_open(const std::string& path);
  [[nodiscard]] const std::map<std::string, Document>& open_documents() const noexcept {
    return open_;
  }
  [[nodiscard]] std::string uri(const std::string& path) const;

  [[nodiscard]] Result<std::string, ReadFailure> read(const std::string& path,
                                                      std::size_t most_bytes) const override;
  [[nodiscard]] std::string shown(const std::string& path) const override { return path; }

  /// Returns nullptr if the file cannot be read.
  [[nodiscard]] FilePointer file(const std::string& path) const;
  /// Returns a file and all files that it includes, each once. Files that cannot be read are left
  /// out.
  [[nodiscard]] ProgramFiles program(const std::string& main_path) const;
  /// Returns every program that the file is part of, among open files and those in the same folder.
  /// A program begins with a file that no other includes. If nothing includes the file, that is its
  /// own program.
  [[nodiscard]] std::vector<ProgramFiles> programs_with(const std::string& path) const;
  /// Returns the BHDL files that an `include` in this file could name.
  [[nodiscard]] std::vector<std::string> beside(const std::string& path) const {
    return folder_.beside(path);
  }

 private:
  using Read = std::map<std::string, FilePointer>;

  [[nodiscard]] FilePointer file(const std::string& path, Read& read_before) const;
  [[nodiscard]] ProgramFiles program(const std::string& main_path, Read& read_before) const;

  const ProgramFolder& folder_;
  const Vocabulary& vocabulary_;
  std::map<std::string, Document> open_;
  mutable std::map<std::string, FilePointer> parsed_;
};

}  // namespace galilean::bhdl::lsp
