#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/bhdl/small_catalog.h"

// Programs that a generator makes, and what becomes of them when they are damaged.

namespace galilean::bhdl {
namespace {

class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

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

std::string damaged(std::string text, Generator& random) {
  static const std::vector<std::string> kPieces{":",
                                                "end",
                                                "\"",
                                                "<",
                                                ")",
                                                ",",
                                                ";",
                                                "-",
                                                "9",
                                                "state:",
                                                "motor_schemas:",
                                                "“",
                                                "\xE2",
                                                "variables:",
                                                "include \"x\"",
                                                "condition:",
                                                "\n",
                                                std::string(1, '\0'),
                                                "name: \"f0\""};
  for (int i = 1 + random.below(8); i > 0 && !text.empty(); --i) {
    const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
    const auto length = static_cast<std::size_t>(random.below(12));
    switch (random.below(4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, random.one_of(kPieces));
        break;
      case 2:
        text.insert(at,
                    text.substr(static_cast<std::size_t>(random.below(static_cast<int>(at) + 1)),
                                length * 4));
        break;
      default:
        text[at] = static_cast<char>(random.below(256));
    }
  }
  return text;
}

// A position may also be the one behind the last character, or behind the last line's end.
void expect_inside(const Diagnostic& diagnostic, const std::string& text) {
  std::vector<int> widths{0};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool ends =
        text[i] == '\n' || (text[i] == '\r' && !(i + 1 < text.size() && text[i + 1] == '\n'));
    if (ends)
      widths.push_back(0);
    else
      ++widths.back();
  }
  EXPECT_EQ(diagnostic.file, "program.bhdl");
  ASSERT_GE(diagnostic.line, 1);
  ASSERT_LE(diagnostic.line, static_cast<int>(widths.size())) << format(diagnostic);
  EXPECT_GE(diagnostic.column, 1);
  EXPECT_LE(diagnostic.column, widths[static_cast<std::size_t>(diagnostic.line) - 1] + 1)
      << format(diagnostic);
}

TEST(RandomPrograms, AreRead) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const std::string text = Generator(seed).program();
    const auto result = check_text(text);
    ASSERT_TRUE(result.program) << "seed " << seed << '\n' << printed(result) << text;
  }
}

TEST(RandomPrograms, GiveAnswersWithPlacesWhenDamaged) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    Generator random(seed);
    const std::string text = damaged(random.program(), random);
    const auto result = check_text(text);
    EXPECT_EQ(result.program.has_value(), !any_error(result.diagnostics)) << seed;
    for (const auto& diagnostic : result.diagnostics) {
      expect_inside(diagnostic, text);
      EXPECT_FALSE(diagnostic.code.empty());
      EXPECT_FALSE(diagnostic.message.empty());
    }
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed << '\n' << text;
  }
}

TEST(RandomPrograms, GiveTheSameAnswerTwice) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    Generator random(seed);
    const std::string text = damaged(random.program(), random);
    EXPECT_EQ(printed(check_text(text)), printed(check_text(text)));
  }
}

}  // namespace
}  // namespace galilean::bhdl
