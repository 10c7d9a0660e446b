// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "bhdl/check/owner.h"
#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// The names that a program gives, each kind in a space of its own: a schema and the variable that
/// it writes may share theirs, as in the published listings.
enum class NameSpace { kDevice, kVariable, kPerceptualSchema, kMotorSchema, kState, kConstant };
[[nodiscard]] NameSpace name_space(ComponentKind kind) noexcept;
/// Where the names are that an attribute with this `refers_to` takes.
[[nodiscard]] NameSpace referred_space(std::string_view refers_to) noexcept;
[[nodiscard]] std::string_view in_words(NameSpace space) noexcept;

class Symbols {
 public:
  struct Entry {
    std::string_view type;  ///< the component's; empty where it is unknown and anything goes
    Position at;
  };

  /// Reports a name that is taken, with the place of the first.
  void declare(NameSpace space, const Word& name, std::string_view type, Diagnostics& diagnostics);
  [[nodiscard]] const Entry* find(NameSpace space, std::string_view name) const noexcept;

  /// Reports a name that stands for nothing of the kind that `spec.refers_to` asks for. A name that
  /// is not there at all is let pass if `text_is_whole` is false: what could not be read may hold
  /// it.
  void check_reference(const AttributeSpec& spec, const ValueNode& name, const Owner& owner,
                       bool text_is_whole, Diagnostics& diagnostics) const;
  /// Reports a bare word that stands where `spec` wants numbers and is no constant's name.
  void refuse_undefined_constant(const AttributeSpec& spec, const ValueNode& word,
                                 const Owner& owner, Diagnostics& diagnostics) const;
  /// The same for a name outside every component; `subject` begins the sentence.
  void check_state(const Word& name, const std::string& subject, bool text_is_whole,
                   Diagnostics& diagnostics) const;

 private:
  [[nodiscard]] Hint hint(NameSpace wanted, std::string_view name) const;
  void refuse_undefined(NameSpace wanted, const Word& name, const std::string& subject,
                        const std::string& note, Diagnostics& diagnostics) const;

  static constexpr std::size_t kSpaces = 6;
  std::array<std::unordered_map<std::string_view, Entry>, kSpaces> entries_;
  std::array<std::vector<std::string_view>, kSpaces> in_order_;  ///< so that hints never change
};

/// "file:line:column"
[[nodiscard]] std::string place(const Position& at);

}  // namespace galilean::bhdl
