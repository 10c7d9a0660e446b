// SPDX-License-Identifier: BSD-3-Clause
// Measures what an operator waits for: a letter typed into a program of 1,000 states, and the names
// that fit.
#include <benchmark/benchmark.h>

#include "bhdl/lsp/server.h"
#include "bhdl/program/catalog_file.h"

namespace galilean::bhdl::lsp {
namespace {

constexpr int kStates = 1000;

std::string large_program() {
  std::string text = "variables:\n  bits: name: \"bumpers\"\nend\nstates:\n";
  for (int i = 0; i < kStates; ++i)
    text += "  state:\n    name: \"state_" + std::to_string(i) +
            "\"\n    condition:\n      bits_variable: \"bumpers\"  bit_index: 1  bit_value: 1\n"
            "      new_state: \"state_" +
            std::to_string((i + 1) % kStates) + "\"\n    end\n  end\n";
  return text + "end\nstart_state: \"";
}

class NoFolder : public ProgramFolder {
 public:
  [[nodiscard]] Result<std::string, ReadFailure> read(const std::string& path,
                                                      std::size_t) const override {
    return ReadFailure{"file/not-found", path};
  }
  [[nodiscard]] std::vector<std::string> beside(const std::string&) const override { return {}; }
};

/// An editor with the program open and its cursor behind the last quote.
class Typing {
 public:
  Typing() : server_(load_catalog(default_catalog_path()).value(), std::make_unique<NoFolder>()) {
    const std::string text = large_program();
    last_line_ = static_cast<std::size_t>(std::ranges::count(text, '\n'));
    tell({{"jsonrpc", "2.0"}, {"id", 1}, {"method", "initialize"}, {"params", Json::object()}});
    tell({{"jsonrpc", "2.0"},
          {"method", "textDocument/didOpen"},
          {"params", {{"textDocument", {{"uri", kUri}, {"version", 1}, {"text", text}}}}}});
  }
  void type(const std::string& letters) { change(last_line_, 14, 14, letters); }
  /// Types a digit behind the bit of the middle condition, and removes it in the next call. The
  /// program never has an error.
  void type_and_take_back_a_digit() {
    change(kMiddleLine, kBehindBit, kBehindBit + (has_digit_ ? 1 : 0), has_digit_ ? "" : "1");
    has_digit_ = !has_digit_;
  }
  std::size_t completion_bytes() {
    return tell({{"jsonrpc", "2.0"},
                 {"id", 2},
                 {"method", "textDocument/completion"},
                 {"params",
                  {{"textDocument", {{"uri", kUri}}},
                   {"position", {{"line", last_line_}, {"character", 14}}}}}});
  }
  std::size_t diagnostics_bytes() {
    std::size_t bytes = 0;
    for (const auto& message : server_.work()) bytes += message.size();
    return bytes;
  }

 private:
  static constexpr const char* kUri = "file:///large.bhdl";
  static constexpr std::size_t kMiddleLine = 4 + 7 * (kStates / 2) + 3;
  static constexpr std::size_t kBehindBit =
      std::string_view("      bits_variable: \"bumpers\"  bit_index: 1").size();

  void change(std::size_t line, std::size_t begin, std::size_t end, const std::string& text) {
    tell({{"jsonrpc", "2.0"},
          {"method", "textDocument/didChange"},
          {"params",
           {{"textDocument", {{"uri", kUri}, {"version", 2}}},
            {"contentChanges",
             {{{"range",
                {{"start", {{"line", line}, {"character", begin}}},
                 {"end", {{"line", line}, {"character", end}}}}},
               {"text", text}}}}}}});
  }
  std::size_t tell(const Json& message) {
    std::size_t bytes = 0;
    for (const auto& answer : server_.receive(message.dump())) bytes += answer.size();
    return bytes;
  }

  Server server_;
  std::size_t last_line_ = 0;
  bool has_digit_ = false;
};

void complete_after_a_letter(benchmark::State& state) {
  Typing typing;
  for (auto _ : state) {
    typing.type("s");
    benchmark::DoNotOptimize(typing.completion_bytes());
  }
}
BENCHMARK(complete_after_a_letter)->Unit(benchmark::kMillisecond);

void diagnose_after_a_letter(benchmark::State& state) {
  Typing typing;
  for (auto _ : state) {
    typing.type("s");
    benchmark::DoNotOptimize(typing.diagnostics_bytes());
  }
}
BENCHMARK(diagnose_after_a_letter)->Unit(benchmark::kMillisecond);

void diagnose_after_a_digit_in_the_middle(benchmark::State& state) {
  Typing typing;
  typing.type("state_0\"");
  for (auto _ : state) {
    typing.type_and_take_back_a_digit();
    benchmark::DoNotOptimize(typing.diagnostics_bytes());
  }
}
BENCHMARK(diagnose_after_a_digit_in_the_middle)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace galilean::bhdl::lsp
