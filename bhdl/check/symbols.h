// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "bhdl/check/attribute_context.h"
#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// The kinds of names. Each kind has a space of its own: a schema and the variable that it writes
/// may have the same name, as in the published listings.
enum class NameSpace { kDevice, kVariable, kPerceptualSchema, kMotorSchema, kState, kConstant };
[[nodiscard]] NameSpace name_space(ComponentKind kind) noexcept;
/// Returns the space of the names that an attribute with this `refers_to` takes.
[[nodiscard]] NameSpace referred_space(std::string_view refers_to) noexcept;
[[nodiscard]] std::string_view in_words(NameSpace space) noexcept;

class Symbols {
 public:
  struct Entry {
    std::string_view type;  ///< the component's type; empty if it is unknown, and then any type
                            ///< fits
    Position at;
  };

  /// Reports a name that is taken, with the place of the first.
  void declare(NameSpace space, const Word& name, std::string_view type, Diagnostics& diagnostics);
  [[nodiscard]] const Entry* find(NameSpace space, std::string_view name) const noexcept;

  /// Reports a name that is not of the kind that `spec.refers_to` demands. A name that is declared
  /// nowhere is not reported if `text_is_whole` is false, because the unread part may declare it.
  void check_reference(const AttributeSpec& spec, const ValueNode& name,
                       const AttributeContext& context, bool text_is_whole,
                       Diagnostics& diagnostics) const;
  /// Reports a bare word that stands in place of numbers and names no constant.
  void refuse_undefined_constant(const AttributeSpec& spec, const ValueNode& word,
                                 const AttributeContext& context, Diagnostics& diagnostics) const;
  /// Checks the name of a state outside every component, as check_reference does. `subject` begins
  /// the sentence.
  void check_state(const Word& name, const std::string& subject, bool text_is_whole,
                   Diagnostics& diagnostics) const;

 private:
  [[nodiscard]] Hint hint(NameSpace wanted, std::string_view name) const;
  void refuse_undefined(NameSpace wanted, const Word& name, const std::string& subject,
                        const std::string& note, Diagnostics& diagnostics) const;

  static constexpr std::size_t kSpaces = 6;
  std::array<std::unordered_map<std::string_view, Entry>, kSpaces> entries_;
  std::array<std::vector<std::string_view>, kSpaces> in_order_;  ///< in the order of the text, so
                                                                 ///< that hints do not depend on
                                                                 ///< the hash table
};

/// Returns "file:line:column".
[[nodiscard]] std::string place(const Position& at);

}  // namespace galilean::bhdl
