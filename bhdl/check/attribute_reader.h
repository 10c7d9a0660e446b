// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/check/symbols.h"
#include "core/catalog/attribute_values.h"

namespace galilean::bhdl {

/// Checks a component's attributes against their declaration and fills in the defaults.
class AttributeReader {
 public:
  /// `text_is_whole` says that the whole text could be read. Otherwise a name that is missing is
  /// not reported, because the unread part may hold it.
  AttributeReader(const Symbols& symbols, bool text_is_whole, Diagnostics& diagnostics)
      : symbols_(symbols), text_is_whole_(text_is_whole), diagnostics_(diagnostics) {}

  /// Returns the values in SI. Attributes that are unknown, given twice, of the wrong type or
  /// missing are reported and left out.
  [[nodiscard]] AttributeValues read(const ComponentSpec& spec, const Word& type,
                                     const std::vector<AttributeNode>& attributes) const;

 private:
  void read_one(const AttributeNode& attribute, const AttributeSpec& spec,
                const AttributeContext& context, AttributeValues& values) const;
  void refuse_second(const AttributeSpec& spec, const Word& second, const Word& first,
                     const AttributeContext& context) const;
  void refuse_unknown(const ComponentSpec& spec, const Word& name) const;
  void refuse_missing(const AttributeSpec& spec, const Word& type,
                      const AttributeContext& context) const;
  void fill_in(const AttributeSpec& spec, const Word& type, const AttributeContext& context,
               AttributeValues& values) const;
  void check_matching_counts(const ComponentSpec& spec, const Word& type,
                             const AttributeContext& context, const AttributeValues& values) const;
  /// `given` is in the order of the spec's attributes. nullptr means that the attribute is not
  /// given.
  void warn_of_unread(const ComponentSpec& spec, const std::vector<const AttributeNode*>& given,
                      const AttributeContext& context, const AttributeValues& values) const;
  void warn_of_alias(const AttributeSpec& spec, const Word& name) const;
  [[nodiscard]] bool constants_exist(const AttributeNode& attribute, const AttributeSpec& spec,
                                     const AttributeContext& context) const;
  void check_names(const AttributeNode& attribute, const AttributeSpec& spec,
                   const AttributeContext& context) const;

  const Symbols& symbols_;
  bool text_is_whole_;
  Diagnostics& diagnostics_;
};

}  // namespace galilean::bhdl
