// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "bhdl/check/vocabulary.h"
#include "bhdl/program/program.h"
#include "bhdl/source/diagnostic.h"
#include "bhdl/source/source_file.h"
#include "bhdl/source/source_provider.h"
#include "bhdl/syntax/loader.h"
#include "core/result.h"

namespace galilean::bhdl {

/// What a check looks for. Warnings take a fifth of the time, and change nothing of a program.
enum class Depth { kErrors, kErrorsAndWarnings };

/// A program, or every reason why the text is none.
struct CheckResult {
  std::optional<Program> program;       ///< set if there was no error; warnings do not count
  std::vector<Diagnostic> diagnostics;  ///< errors and warnings, in the order of the text
  std::vector<SourceFile> files;        ///< all files that were read, the main file first, also if
                                        ///< there are errors
};

/// Checks texts in memory, as a push over the network brings them. The first is the main file. The
/// others are found among `files` by the path that `include` gives, relative to the file that
/// includes. The disk is never read. Any input gets an answer in linear time.
[[nodiscard]] CheckResult check(std::vector<SourceFile> files, const Vocabulary& vocabulary);
/// Makes a vocabulary for this check alone.
[[nodiscard]] CheckResult check(std::vector<SourceFile> files, const Catalog& catalog);

/// Checks texts that `sources` reads.
[[nodiscard]] CheckResult check(const std::string& main_path, const SourceProvider& sources,
                                const Vocabulary& vocabulary,
                                Depth depth = Depth::kErrorsAndWarnings);
[[nodiscard]] CheckResult check(const std::string& main_path, const SourceProvider& sources,
                                const Catalog& catalog);

/// Returns the errors and warnings alone. `read` gives the trees of files that were read before.
[[nodiscard]] std::vector<Diagnostic> diagnose(const std::string& main_path,
                                               const SourceProvider& sources,
                                               const TreeReader& read,
                                               const Vocabulary& vocabulary);

/// Reads a file on disk and all that it includes, for somebody else who checks it. The paths are
/// relative to the main file's folder. Errors: a file cannot be read, is no text, or there are too
/// many; each with its place.
[[nodiscard]] Result<std::vector<SourceFile>, std::vector<Diagnostic>> read_program(
    const std::filesystem::path& path);

/// Checks a file on disk and what it includes. The paths in `files` are relative to the main file's
/// folder, so that a program has the same hash in every folder. The paths in the diagnostics begin
/// as `path` does.
[[nodiscard]] CheckResult check_file(const std::filesystem::path& path,
                                     const Vocabulary& vocabulary,
                                     Depth depth = Depth::kErrorsAndWarnings);
[[nodiscard]] CheckResult check_file(const std::filesystem::path& path, const Catalog& catalog);

/// Returns the paths of all files that a program on disk is read from, as far as they can be read:
/// the main file first, then those that are included.
[[nodiscard]] std::vector<std::string> files_of(const std::filesystem::path& path);

}  // namespace galilean::bhdl
