// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/schemas/ros2idl.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "monitor/schemas/idl_reader.h"

namespace galilean::monitor {
namespace {

using wire::TypeKind;

/// Kinds of definitions whose messages are not decoded.
constexpr std::array<std::string_view, 4> kPassedOver{"union", "bitmask", "bitset", "interface"};
constexpr int kDeepestIdl = 32;  // sequences of sequences, and modules in modules

struct IdlWord {
  std::string_view word;
  TypeKind kind;
};
constexpr std::array<IdlWord, 19> kIdlWords{{{"boolean", TypeKind::kBoolean},
                                             {"octet", TypeKind::kByte},
                                             {"uint8", TypeKind::kByte},
                                             {"int8", TypeKind::kInt8},
                                             {"char", TypeKind::kChar},
                                             {"short", TypeKind::kInt16},
                                             {"int16", TypeKind::kInt16},
                                             {"unsigned short", TypeKind::kUint16},
                                             {"uint16", TypeKind::kUint16},
                                             {"long", TypeKind::kInt32},
                                             {"int32", TypeKind::kInt32},
                                             {"unsigned long", TypeKind::kUint32},
                                             {"uint32", TypeKind::kUint32},
                                             {"long long", TypeKind::kInt64},
                                             {"int64", TypeKind::kInt64},
                                             {"unsigned long long", TypeKind::kUint64},
                                             {"uint64", TypeKind::kUint64},
                                             {"float", TypeKind::kFloat},
                                             {"double", TypeKind::kDouble}}};

/// Reads definitions by recursive descent. The first mistake ends it.
class IdlParser {
 public:
  explicit IdlParser(std::string_view text) : reader_(text) {}

  Result<Definitions> run() {
    while (reader_.ok() && !reader_.at_end()) definition("", 0);
    if (!reader_.ok()) return Error{reader_.problem()};
    return std::move(definitions_);
  }

 private:
  void definition(const std::string& scope, int depth) {
    const auto notes = reader_.annotations();
    if (reader_.accept("module"))
      enter_module(scope, depth);
    else if (reader_.accept("struct"))
      structure(scope, notes);
    else if (reader_.accept("typedef"))
      alias(scope);
    else if (reader_.accept("enum"))
      enumeration(scope);
    else if (reader_.accept("const"))
      constant(scope);
    else if (std::ranges::find(kPassedOver, reader_.next()) != kPassedOver.end())
      other(scope, reader_.take());
    else
      return reader_.fail("a definition");
    reader_.expect(";");
  }

  void enter_module(const std::string& scope, int depth) {
    const auto inner = joined(scope, reader_.name());
    if (depth > kDeepestIdl) return reader_.fail("an end of the modules in modules");
    reader_.expect("{");
    while (reader_.ok() && !reader_.accept("}")) {
      if (reader_.next().empty()) return reader_.fail("'}'");
      definition(inner, depth + 1);
    }
  }

  static std::string joined(const std::string& scope, const std::string& inner) {
    return scope.empty() ? inner : scope + "::" + inner;
  }

  Definition& begin(const std::string& scope, Definition::Kind kind, const std::string& called) {
    auto& made = definitions_[joined(scope, called)];
    made = {};
    made.kind = kind;
    made.scope = scope;
    return made;
  }

  void structure(const std::string& scope, const Annotations& notes) {
    const auto called = reader_.name();
    if (reader_.next() == ";") return;  // it is announced only
    auto& made = begin(scope, Definition::Kind::kStruct, called);
    made.extensibility = notes.extensibility;
    if (reader_.accept(":")) add_base(scope, made);
    reader_.expect("{");
    while (reader_.ok() && !reader_.accept("}")) field(made);
  }

  /// The fields of a base stand before a struct's own. The base stands before the struct.
  void add_base(const std::string& scope, Definition& to) {
    const auto called = reader_.name();
    auto base = definitions_.find(joined(scope, called));
    if (base == definitions_.end()) base = definitions_.find(called);
    if (base == definitions_.end()) return reader_.fail("a struct behind its base");
    to.fields = base->second.fields;
  }

  void field(Definition& to) {
    const auto notes = reader_.annotations();
    WrittenField made;
    made.optional = notes.optional;
    made.key = notes.key;
    made.type = type(0);
    do {
      made.name = reader_.name();
      made.sizes = sizes();
      if (reader_.ok()) to.fields.push_back(made);
    } while (reader_.ok() && reader_.accept(","));
    reader_.expect(";");
  }

  std::vector<std::uint32_t> sizes() {
    std::vector<std::uint32_t> all;
    while (reader_.ok() && reader_.accept("[")) {
      if (const auto size = bound()) all.push_back(*size);
      reader_.expect("]");
    }
    return all;
  }

  /// Reads a number, or the name of a constant before.
  std::optional<std::uint32_t> bound() {
    const auto token = reader_.next();
    auto number = IdlReader::whole_number(token);
    if (const auto known = constants_.find(token); !number && known != constants_.end())
      number = known->second;
    if (number && *number >= 0 && *number <= UINT32_MAX)
      return (void)reader_.take(), static_cast<std::uint32_t>(*number);
    return reader_.fail("a size"), std::nullopt;
  }

  WrittenType type(int depth) {
    WrittenType made;
    if (depth > kDeepestIdl) return reader_.fail("an end of the sequences of sequences"), made;
    if (reader_.accept("sequence")) {
      made.kind = WrittenType::Kind::kSequence;
      reader_.expect("<");
      made.element = std::make_shared<WrittenType>(type(depth + 1));
      if (reader_.accept(",")) made.bound = bound();
      reader_.expect(">");
      return made;
    }
    if (reader_.accept("string")) {
      made.kind = WrittenType::Kind::kString;
      if (reader_.accept("<")) {
        made.bound = bound();
        reader_.expect(">");
      }
      return made;
    }
    return basic_or_named();
  }

  WrittenType basic_or_named() {
    WrittenType made;
    made.name = reader_.name();
    while ((made.name == "unsigned" || made.name == "long" || made.name == "unsigned long") &&
           (reader_.next() == "long" || reader_.next() == "short"))
      made.name += " " + std::string(reader_.take());
    if (made.name == "long" && reader_.accept("double")) made.name = "long double";
    for (const auto& [word, kind] : kIdlWords)
      if (word == made.name) {
        made.kind = WrittenType::Kind::kPrimitive;
        made.primitive = kind;
      }
    if (made.name.starts_with("::")) made.name.erase(0, 2);
    return made;
  }

  void alias(const std::string& scope) {
    WrittenField stands_for;
    stands_for.type = type(0);
    do {
      stands_for.name = reader_.name();
      stands_for.sizes = sizes();
      if (reader_.ok())
        begin(scope, Definition::Kind::kAlias, stands_for.name).fields = {stands_for};
    } while (reader_.ok() && reader_.accept(","));
  }

  void enumeration(const std::string& scope) {
    auto& made = begin(scope, Definition::Kind::kEnum, reader_.name());
    reader_.expect("{");
    long long value = 0;
    while (reader_.ok() && !reader_.accept("}")) {
      value = reader_.annotations().value.value_or(value);
      if (value < INT32_MIN || value > INT32_MAX) return reader_.fail("a value of 32 bits");
      made.constants.push_back({reader_.name(), static_cast<std::int32_t>(value++)});
      if (!reader_.accept(",") && reader_.next() != "}") reader_.fail("',' or '}'");
    }
  }

  void constant(const std::string& scope) {
    (void)type(0);
    const auto called = reader_.name();
    reader_.expect("=");
    if (const auto number = IdlReader::whole_number(reader_.next())) {
      constants_[called] = *number;
      constants_[joined(scope, called)] = *number;
    }
    while (reader_.ok() && reader_.next() != ";" && !reader_.next().empty()) reader_.take();
  }

  void other(const std::string& scope, std::string_view word) {
    begin(scope, Definition::Kind::kOther, reader_.name()).word = word;
    for (int depth = 0;
         reader_.ok() && !reader_.next().empty() && (depth > 0 || reader_.next() != ";");) {
      const auto token = reader_.take();
      depth += token == "{" ? 1 : token == "}" ? -1 : 0;
    }
  }

  IdlReader reader_;
  Definitions definitions_;
  std::map<std::string, long long, std::less<>> constants_;
};

}  // namespace

Result<Definitions> parse_ros2idl(std::string_view text) {
  return IdlParser(text).run();
}

}  // namespace galilean::monitor
