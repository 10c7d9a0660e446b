// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bhdl/syntax/token_stream.h"
#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// Returns the kind of components whose section the word opens. `percp_schemas` opens perceptual
/// schemas, too.
[[nodiscard]] std::optional<ComponentKind> section_kind(std::string_view word) noexcept;
/// Returns the word of the section that this kind belongs in, as the reference spells it.
[[nodiscard]] std::string_view section_word(ComponentKind kind) noexcept;

/// Returns every word that opens a section or says something of the whole program. Editors use the
/// list, too.
[[nodiscard]] std::vector<std::string_view> opening_words();

/// Returns every word that begins a section or stands for one, except a bare `state`. Of two
/// spellings only one is in the list.
[[nodiscard]] std::vector<std::string_view> section_words();

/// Returns whether a section, a bare state, `define`, `expect`, an include, `start_state` or
/// `on_swap` begins here. The same word with a value behind it is an attribute or a state's list:
/// `motor_schemas: "noise"`.
[[nodiscard]] bool at_section(const TokenStream& tokens);
/// Returns the same where no block is open, so that the word can mean nothing else.
[[nodiscard]] bool at_section_word(const TokenStream& tokens);
/// Returns the section word that a misspelt label here must have meant, or an empty text if none.
[[nodiscard]] std::string_view meant_section(const TokenStream& tokens);

/// Returns whether a state's list of schemas begins here. A component's label behind the word makes
/// it a section.
[[nodiscard]] bool at_schema_list(const TokenStream& tokens);
/// Returns whether anything but `end` shows here that a condition is over.
[[nodiscard]] bool at_next_part_of_state(const TokenStream& tokens);

/// Takes `end` or `end:`. Of `end;` the lexer sees only `end`.
void take_end(TokenStream& tokens);

}  // namespace galilean::bhdl
