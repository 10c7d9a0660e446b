// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bhdl/source/source_file.h"
#include "core/catalog/catalog.h"

namespace galilean::monitor::top {

/// A gain or a threshold that a program writes as a number. The page finds the same ones, with the
/// same ranges: web/src/gains/tunables.ts.
struct Tunable {
  std::string key;     ///< the same as long as the program has this number, whatever its value
  std::string schema;  ///< its name
  std::string label;   ///< "gain of from_robot", "threshold"
  std::string unit;    ///< that the text writes it in; empty: none
  double value = 0;    ///< in `unit`, as are those that follow
  double min = 0;
  double max = 0;
  double step = 1;
  std::size_t file = 0;   ///< where its digits stand: in which file, …
  std::size_t begin = 0;  ///< … from which byte, …
  std::size_t size = 0;   ///< … and how many bytes
};

/// Returns the tunables of a program in the order of the text. Numbers that stand in no text but in
/// the catalog are left out, and constants are not followed.
[[nodiscard]] std::vector<Tunable> tunables_in(const std::vector<bhdl::SourceFile>& files,
                                               const Catalog& catalog);

/// Returns the files with these texts in place of numbers, by their tunables' keys. Every other
/// character stays. Keys that the program does not have are left out.
[[nodiscard]] std::vector<bhdl::SourceFile> with_numbers(
    const std::vector<bhdl::SourceFile>& files, const Catalog& catalog,
    const std::map<std::string, std::string>& numbers);

/// Returns the number as BHDL writes it, with no more digits than its step has.
[[nodiscard]] std::string number_text(double value, double step);
/// Returns the number with all its digits, and without the exponent that BHDL does not know.
[[nodiscard]] std::string exact_text(double value);

}  // namespace galilean::monitor::top
