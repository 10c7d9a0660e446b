// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/source/readable.h"

#include "bhdl/source/text.h"

namespace galilean::bhdl {

bool is_readable(const std::string& file, std::string_view text, Diagnostics& diagnostics) {
  const auto bad = find_bad_text(text);
  if (!bad) return true;
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  const std::string byte{'0', 'x', kDigits[bad->byte >> 4], kDigits[bad->byte & 15]};
  const bool binary = bad->kind == BadText::Kind::kBinary;
  diagnostics.error({file, bad->line, bad->column}, binary ? "file/binary" : "file/not-utf8",
                    binary ? "this is not a text: it holds the byte " + byte
                           : "this is not UTF-8: the byte " + byte + " is out of place",
                    "save the file as UTF-8 text");
  return false;
}

}  // namespace galilean::bhdl
