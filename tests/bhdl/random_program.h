// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <string>
#include <vector>

namespace galilean::bhdl {

/// Writes correct programs for the small catalog, with every quirk of the published listings.
class RandomProgram {
 public:
  explicit RandomProgram(unsigned seed) : random_(seed) {}

  int below(int limit) { return std::uniform_int_distribution(0, limit - 1)(random_); }
  bool chance() { return below(2) == 0; }
  template <class Items>
  const auto& one_of(const Items& items) {
    return items[static_cast<std::size_t>(below(static_cast<int>(std::size(items))))];
  }

  std::string program() {
    const int forces = 1 + below(5);
    const int schemas = 1 + below(5);
    const int states = 1 + below(6);
    std::string text = maybe_comment() + "variables:" + blank();
    for (int i = 0; i < forces; ++i)
      text += "force:" + blank() + "name: " + name("f", i) + maybe_pair() + maybe_end();
    text += "bits: name: " + name("b", 0) + maybe_end() + "shaft: name: " + quoted_text("shaft");
    text += end() + section_end() + "motor_schemas:" + blank();
    for (int i = 0; i < schemas; ++i)
      text += "noise:" + blank() + "name: " + name("m", i) + blank() +
              "persistence: " + std::to_string(below(600)) + blank() +
              "result: " + name("f", below(forces)) + end();
    text += section_end();
    for (int i = 0; i < states; ++i) text += state(i, states, schemas);
    return text;
  }

 private:
  std::string state(int index, int states, int schemas) {
    std::string text = "state: name: " + name("s", index) + blank() + "motor_schemas:" + blank();
    for (int i = 0; i < schemas; ++i)
      if (chance()) text += name("m", i) + blank();
    text += end();
    for (int i = below(4); i > 0; --i)
      text += "condition: bits_variable: " + name("b", 0) + blank() +
              "bit_index: " + std::to_string(below(32)) + blank() +
              "bit_value: " + std::to_string(below(2)) + blank() +
              "new_state: " + name("s", below(states)) + end();
    return text + end();
  }

  std::string blank() {
    static const std::vector<std::string> kBlanks{" ", "\n", "\t", "  \r\n", " ; words: “x\n"};
    return one_of(kBlanks);
  }
  std::string end() {
    static const std::vector<std::string> kEnds{" end\n", "\nend:\n", " end; x\n"};
    return one_of(kEnds);
  }
  std::string maybe_end() { return chance() ? end() : "\n"; }
  std::string section_end() { return chance() ? end() : "\n"; }
  std::string maybe_comment() { return chance() ? "; a comment\n" : ""; }
  std::string maybe_pair() { return chance() ? " value: <–1, 2.5>" : ""; }
  std::string quoted_text(const std::string& text) {
    return chance() ? "“" + text + "”" : "\"" + text + "\"";
  }
  std::string name(const std::string& letter, int index) {
    return quoted_text(letter + std::to_string(index));
  }

  std::mt19937 random_;
};

/// Returns `text` with a few letters lost, doubled or exchanged for others.
[[nodiscard]] std::string damaged(std::string text, RandomProgram& random);

}  // namespace galilean::bhdl
