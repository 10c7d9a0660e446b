// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {

/// What a block is, which decides what may close it besides `end`.
enum class Block {
  kComponent,  ///< nothing: a missing `end` is an error
  kVariable,   ///< the next component too, as the published listings print it
  kCondition,  ///< nothing
  kStep        ///< nothing; of an expectation
};

/// `type : { attribute } end`. The stream stands at the type.
void parse_component(TokenStream& tokens, Block block, Diagnostics& diagnostics);

/// `name : value …`, or a report of what stands in its place. Always takes at least a token.
void parse_attribute(TokenStream& tokens, Diagnostics& diagnostics);

/// Reports at the stream's place that the block of the label `opened` should have been closed
/// before.
void report_unclosed(const TokenStream& tokens, const Token& opened, Diagnostics& diagnostics);

/// Reports that the word at the stream's place lacks its colon.
void report_missing_colon(const TokenStream& tokens, Diagnostics& diagnostics);

/// Takes a word and its colon, if it has one. Returns the word.
Token take_label(TokenStream& tokens);

}  // namespace galilean::bhdl
