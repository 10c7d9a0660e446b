// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {

/// The kind of a block. It decides what may close the block besides `end`.
enum class Block {
  kComponent,  ///< nothing: a missing `end` is an error
  kVariable,   ///< also the next component, as the published listings print it
  kCondition,  ///< nothing
  kStep        ///< a step of an expectation; nothing
};

/// Reads `type : { attribute } end`. Requires: the stream stands at the type.
void parse_component(TokenStream& tokens, Block block, Diagnostics& diagnostics);

/// Reads `name : value …`, or reports what stands in its place. It always takes at least one
/// token.
void parse_attribute(TokenStream& tokens, Diagnostics& diagnostics);

/// Reports at the stream's place that the block of the label `opened` should have been closed
/// before.
void report_unclosed(const TokenStream& tokens, const Token& opened, Diagnostics& diagnostics);

/// Reports that the word at the stream's place lacks its colon.
void report_missing_colon(const TokenStream& tokens, Diagnostics& diagnostics);

/// Takes a word and its colon, if it has one. Returns the word.
Token take_label(TokenStream& tokens);

}  // namespace galilean::bhdl
