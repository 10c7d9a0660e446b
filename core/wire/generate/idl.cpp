// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/generate/idl.h"

#include <cctype>
#include <set>
#include <stdexcept>

namespace galilean::idl {
namespace {

struct Token {
  std::string text;
  int line;
  std::size_t begin;
};

class Tokens {
 public:
  Tokens(std::string file, const std::string& text, std::vector<std::string>& includes)
      : file_(std::move(file)), text_(text) {
    scan(text, includes);
  }

  [[nodiscard]] bool done() const { return next_ == tokens_.size(); }
  [[nodiscard]] const std::string& peek() const {
    if (done()) fail("the file ends too early");
    return tokens_[next_].text;
  }
  std::string take() {
    std::string text = peek();
    ++next_;
    return text;
  }
  bool accept(std::string_view text) {
    if (done() || tokens_[next_].text != text) return false;
    ++next_;
    return true;
  }
  void expect(std::string_view text) {
    if (!accept(text)) fail("expected '" + std::string(text) + "' before '" + peek() + "'");
  }
  /// Returns where the lines behind the last token begin.
  [[nodiscard]] std::size_t next_line() const {
    return std::min(text_.find('\n', tokens_[next_ - 1].begin), text_.size() - 1) + 1;
  }
  /// Returns the whole lines from `begin` to the last token.
  [[nodiscard]] std::string lines_since(std::size_t begin) const {
    return text_.substr(begin, next_line() - begin);
  }
  [[noreturn]] void fail(const std::string& message) const {
    const int line = tokens_.empty() ? 1 : tokens_[std::min(next_, tokens_.size() - 1)].line;
    throw std::runtime_error(file_ + ".idl:" + std::to_string(line) + ": error: " + message);
  }

 private:
  void scan(const std::string& text, std::vector<std::string>& includes) {
    int line = 1;
    for (std::size_t i = 0; i < text.size();) {
      const char c = text[i];
      if (c == '\n') ++line;
      if (std::isspace(static_cast<unsigned char>(c))) {
        ++i;
      } else if (text.compare(i, 2, "//") == 0) {
        i = std::min(text.find('\n', i), text.size());
      } else if (c == '#') {
        const std::size_t end = std::min(text.find('\n', i), text.size());
        const std::size_t open = text.find('"', i), dot = text.find(".idl", i);
        if (open < end && dot < end) includes.push_back(text.substr(open + 1, dot - open - 1));
        i = end;
      } else {
        i = scan_word(text, i, line);
      }
    }
  }
  std::size_t scan_word(const std::string& text, std::size_t begin, int line) {
    std::size_t end = begin;
    const auto is_word = [&](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == ':';
    };
    while (end < text.size() && is_word(text[end])) ++end;
    if (end == begin) ++end;
    tokens_.push_back({text.substr(begin, end - begin), line, begin});
    return end;
  }

  std::string file_;
  const std::string& text_;
  std::vector<Token> tokens_;
  std::size_t next_ = 0;
};

std::string take_type(Tokens& tokens, const std::string& module) {
  std::string type = tokens.take();
  while (type == "unsigned" || type.ends_with("long")) {
    const std::string& next = tokens.peek();
    if (next != "long" && next != "short") break;
    type += " " + tokens.take();
  }
  const bool is_struct = type != "string" && !basic_type(type);
  return is_struct && type.find("::") == std::string::npos ? module + "::" + type : type;
}

Field parse_field(Tokens& tokens, const std::string& module) {
  Field field;
  if (tokens.accept("sequence")) {
    field.sequence = true;
    tokens.expect("<");
    field.type = take_type(tokens, module);
    tokens.expect(">");
  } else {
    field.type = take_type(tokens, module);
  }
  field.name = tokens.take();
  if (tokens.accept("[")) {
    field.array_size = std::stoi(tokens.take());
    tokens.expect("]");
  }
  tokens.expect(";");
  return field;
}

Struct parse_struct(Tokens& tokens, const std::string& module) {
  Struct result{module, tokens.take(), {}, {}};
  tokens.expect("{");
  while (!tokens.accept("}")) result.fields.push_back(parse_field(tokens, module));
  tokens.expect(";");
  return result;
}

Constant parse_constant(Tokens& tokens, const std::string& module) {
  tokens.take();
  Constant constant{module.substr(module.rfind(':') + 1), tokens.take(), {}};
  tokens.expect("=");
  constant.value = tokens.take();
  tokens.expect(";");
  return constant;
}

void parse_module(Tokens& tokens, const std::string& outer, File& file) {
  const std::string name = tokens.take();
  const std::string module = outer.empty() ? name : outer + "::" + name;
  tokens.expect("{");
  while (!tokens.accept("}")) {
    const std::size_t begin = tokens.next_line();
    if (tokens.accept("module")) {
      const std::string inner = tokens.peek();
      parse_module(tokens, module, file);
      file.group_text[inner] = tokens.lines_since(begin);
    } else if (tokens.accept("const")) {
      file.constants.push_back(parse_constant(tokens, module));
    } else {
      tokens.expect("@");
      tokens.expect("final");
      tokens.expect("struct");
      file.structs.push_back(parse_struct(tokens, module));
      file.structs.back().text = tokens.lines_since(begin);
    }
  }
  tokens.expect(";");
}

}  // namespace

const Basic* basic_type(std::string_view type) {
  static const std::map<std::string_view, Basic> kBasic{
      {"boolean", {"bool", 1}},
      {"octet", {"std::uint8_t", 1}},
      {"uint8", {"std::uint8_t", 1}},
      {"int8", {"std::int8_t", 1}},
      {"short", {"std::int16_t", 2}},
      {"unsigned short", {"std::uint16_t", 2}},
      {"long", {"std::int32_t", 4}},
      {"unsigned long", {"std::uint32_t", 4}},
      {"long long", {"std::int64_t", 8}},
      {"unsigned long long", {"std::uint64_t", 8}},
      {"unsigned", {"", 0}},  // the first word of a longer name
      {"float", {"float", 4}},
      {"double", {"double", 8}}};
  const auto found = kBasic.find(type);
  return found == kBasic.end() ? nullptr : &found->second;
}

File parse(const std::string& name, const std::string& text) {
  File file;
  file.name = name;
  file.text = text;
  Tokens tokens(name, text, file.includes);
  while (!tokens.done()) {
    tokens.expect("module");
    parse_module(tokens, "", file);
  }
  return file;
}

bool is_appended(const Field& field) {
  return field.type == "galilean_msgs::msg::Signature";
}

}  // namespace galilean::idl
