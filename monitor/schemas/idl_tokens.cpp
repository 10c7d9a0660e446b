// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/schemas/idl_tokens.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace galilean::monitor {
namespace {

bool is_name_letter(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

class IdlLexer {
 public:
  explicit IdlLexer(std::string_view text) : rest_(text) {}

  std::vector<std::string_view> run() {
    for (skip(); !rest_.empty(); skip()) tokens_.push_back(take(token_size()));
    return std::move(tokens_);
  }

 private:
  std::string_view take(std::size_t size) {
    const auto taken = rest_.substr(0, size);
    rest_.remove_prefix(taken.size());
    at_line_start_ = at_line_start_ && taken.find_first_not_of(" \t\r") == taken.npos;
    if (taken.ends_with('\n')) at_line_start_ = true;
    return taken;
  }

  void skip_line() { take(std::min(rest_.find('\n'), rest_.size() - 1) + 1); }

  /// Returns whether the line here is none of the language.
  [[nodiscard]] bool is_foreign_line() const {
    return at_line_start_ &&
           (rest_.starts_with("===") || rest_.starts_with("IDL:") || rest_.starts_with('#'));
  }

  void skip() {
    while (!rest_.empty()) {
      if (is_foreign_line() || rest_.starts_with("//"))
        skip_line();
      else if (rest_.starts_with("/*"))
        take(rest_.find("*/", 2) == rest_.npos ? rest_.size() : rest_.find("*/", 2) + 2);
      else if (std::isspace(static_cast<unsigned char>(rest_.front())) != 0)
        take(1);
      else
        return;
    }
  }

  [[nodiscard]] std::size_t token_size() const {
    const char first = rest_.front();
    if (first == '"') return text_size();
    if (!is_name_letter(first) && !rest_.starts_with("::")) return 1;
    std::size_t size = 0;
    while (size < rest_.size()) {
      if (is_name_letter(rest_[size]) || (rest_[size] == '.' && is_digit_before(size)))
        ++size;
      else if (rest_.substr(size).starts_with("::"))
        size += 2;
      else
        break;
    }
    return size;
  }

  [[nodiscard]] bool is_digit_before(std::size_t at) const {
    return at > 0 && std::isdigit(static_cast<unsigned char>(rest_[at - 1])) != 0;
  }

  [[nodiscard]] std::size_t text_size() const {
    for (std::size_t at = 1; at < rest_.size(); ++at) {
      if (rest_[at] == '\\')
        ++at;
      else if (rest_[at] == '"')
        return at + 1;
    }
    return rest_.size();
  }

  std::string_view rest_;
  bool at_line_start_ = true;
  std::vector<std::string_view> tokens_;
};

}  // namespace

std::vector<std::string_view> idl_tokens(std::string_view text) {
  return IdlLexer(text).run();
}

}  // namespace galilean::monitor
