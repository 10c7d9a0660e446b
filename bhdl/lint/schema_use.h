// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "bhdl/check/vocabulary.h"
#include "bhdl/program/program.h"

namespace galilean::bhdl {

/// Bits of a variable that a schema writes.
struct WrittenBits {
  std::size_t variable = 0;
  std::uint32_t bits = ~std::uint32_t{0};
};

/// The variables that a schema of a program uses, as its declaration in the catalog says. Variables
/// are counted as in Program::variables.
struct SchemaUse {
  const Component* component = nullptr;
  const ComponentSpec* spec = nullptr;
  std::vector<std::size_t> reads;    ///< including updates
  std::vector<std::size_t> writes;   ///< as a whole: the old value is gone
  std::vector<std::size_t> updates;  ///< in part: it reads and writes
  std::vector<WrittenBits> written;  ///< all that it writes or updates
  std::vector<std::size_t> adjusts;  ///< the variables whose fading it sets
};

/// The uses of all schemas, and which of them each state lists. It points into the program and the
/// vocabulary.
class SchemaUses {
 public:
  SchemaUses(const Program& program, const Vocabulary& vocabulary);

  struct Listed {
    std::vector<const SchemaUse*> perceptual;  ///< in the order of the list
    std::vector<const SchemaUse*> motor;
  };

  [[nodiscard]] const std::vector<SchemaUse>& all() const noexcept { return all_; }
  /// Returns the schemas of a state, counted as in Program::states.
  [[nodiscard]] const Listed& listed(std::size_t state) const noexcept { return listed_[state]; }
  /// Requires: the variable exists.
  [[nodiscard]] std::size_t variable(std::string_view name) const { return variables_.at(name); }

 private:
  void add(const Component& component, const Vocabulary& vocabulary);
  void add_names(const Value* value, std::vector<std::size_t>& into) const;

  std::unordered_map<std::string_view, std::size_t> variables_;
  std::vector<SchemaUse> all_;
  std::vector<Listed> listed_;
};

}  // namespace galilean::bhdl
