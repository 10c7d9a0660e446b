// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bhdl/syntax/token_stream.h"
#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// The section of components that a word opens: `percp_schemas` is perceptual schemas'.
[[nodiscard]] std::optional<ComponentKind> section_kind(std::string_view word) noexcept;
/// The section that a component of this kind belongs in, as the reference spells it.
[[nodiscard]] std::string_view section_word(ComponentKind kind) noexcept;

/// Every word that opens a section or says something of the whole program. Editors know them too.
[[nodiscard]] std::vector<std::string_view> opening_words();

/// Every word that begins a section or stands for one, but for a bare `state`; none has two
/// spellings here.
[[nodiscard]] std::vector<std::string_view> section_words();

/// Whether a section, a bare state, `define`, `expect`, an include, `start_state` or `on_swap`
/// begins here. The same
/// word with a value behind it is an attribute or a state's list: `motor_schemas: "noise"`.
[[nodiscard]] bool at_section(const TokenStream& tokens);
/// The same where no block is open, and the word can mean nothing else.
[[nodiscard]] bool at_section_word(const TokenStream& tokens);
/// The section word that a misspelt label here must have meant; empty if none.
[[nodiscard]] std::string_view meant_section(const TokenStream& tokens);

/// A state's list of schemas. A component's label behind the word makes it a section's.
[[nodiscard]] bool at_schema_list(const TokenStream& tokens);
/// Whatever else than `end` makes clear that a condition is over.
[[nodiscard]] bool at_next_part_of_state(const TokenStream& tokens);

/// `end`, `end:` or (what the lexer sees of `end;`) `end`.
void take_end(TokenStream& tokens);

}  // namespace galilean::bhdl
