// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// A catalog as BHDL uses it. Variables and schemas have a name, and look-up takes constant time.
/// Making one takes longer than checking a small program, so that a caller that checks often keeps
/// it.
class Vocabulary {
 public:
  explicit Vocabulary(const Catalog& catalog);
  Vocabulary(const Vocabulary&) = delete;
  Vocabulary& operator=(const Vocabulary&) = delete;

  [[nodiscard]] const ComponentSpec* find(std::string_view component) const noexcept;
  [[nodiscard]] const std::vector<ComponentSpec>& components() const noexcept {
    return components_;
  }

 private:
  std::vector<ComponentSpec> components_;
  std::unordered_map<std::string_view, const ComponentSpec*> by_name_;
};

[[nodiscard]] bool is_device(ComponentKind kind) noexcept;
/// Returns the kind as a sentence says it: "motor schema".
[[nodiscard]] std::string_view kind_in_words(ComponentKind kind) noexcept;
/// Returns what an attribute takes, as a sentence says it: "a number in cm", "the name of a locate
/// variable".
[[nodiscard]] std::string expectation(const AttributeSpec& spec);
/// Returns the least and the greatest value that an attribute takes: "0 to 31", "at least 0 cm".
/// The text is empty if any value is taken.
[[nodiscard]] std::string range_in_words(const AttributeSpec& spec);

}  // namespace galilean::bhdl
