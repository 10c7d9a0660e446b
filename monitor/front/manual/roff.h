// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean::front {

/// A manual page in the making, in roff with the macros of man(7). Every text may hold any
/// character: those that roff would obey are escaped.
class Roff {
 public:
  /// `name` is the page's, such as "galilean-sim"; `release` stands at its foot.
  Roff(const std::string& name, const std::string& release);

  void section(const std::string& title);
  void subsection(const std::string& title);
  void paragraph(const std::string& text);
  /// A term, and what there is to say of it. Requires: `term` is made by bold, italic and plain.
  void item(const std::string& term, const std::string& text);
  /// A line of a synopsis. Requires: as for item's term.
  void synopsis(const std::string& line);

  [[nodiscard]] static std::string bold(const std::string& text);
  [[nodiscard]] static std::string italic(const std::string& text);
  [[nodiscard]] static std::string plain(const std::string& text);

  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  std::string text_;
};

}  // namespace galilean::front
