#include "bench/support/arguments.h"

#include <cstdio>
#include <string>
#include <string_view>

#include "core/text/text_cursor.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

std::size_t parse_seeds(std::string_view word) {
  const auto seeds = parse_integer(word);
  if (!seeds || *seeds < 1) {
    throw InvalidInput("--seeds: expected a number from 1, found " + in_quotes(word));
  }
  return static_cast<std::size_t>(*seeds);
}

// Walks through the command line and leaves behind what is not ours.
class Walk {
 public:
  Walk(int argc, char** argv) : argc_(argc), argv_(argv) {}

  bool next() {
    if (++at_ >= argc_) return false;
    word_ = argv_[at_];
    return true;
  }
  [[nodiscard]] std::string_view word() const { return word_; }
  void keep() { argv_[kept_++] = argv_[at_]; }
  int end() {
    argv_[kept_] = nullptr;
    return kept_;
  }

  /// "--option VALUE" or "--option=VALUE".
  std::optional<std::string_view> value_of(std::string_view option) {
    if (word_ == option) {
      if (!next()) throw InvalidInput(std::string(option) + ": a value is missing");
      return word_;
    }
    const bool is_joined =
        word_.starts_with(option) && word_.size() > option.size() && word_[option.size()] == '=';
    if (!is_joined) return std::nullopt;
    return word_.substr(option.size() + 1);
  }

 private:
  int argc_;
  char** argv_;
  int at_ = 0;
  int kept_ = 1;
  std::string_view word_;
};

}  // namespace

Arguments take_arguments(int& argc, char** argv) {
  Arguments arguments;
  Walk walk(argc, argv);
  while (walk.next()) {
    if (const auto file = walk.value_of("--mesh")) {
      arguments.meshes.emplace_back(*file);
    } else if (const auto seeds = walk.value_of("--seeds")) {
      arguments.seeds = parse_seeds(*seeds);
    } else {
      arguments.help = arguments.help || walk.word() == "--help";
      walk.keep();
    }
  }
  argc = walk.end();
  return arguments;
}

void print_help() {
  std::fputs(
      "Times the stages of geolloyd, each after its result has been verified.\n"
      "\n"
      "geolloyd_bench [--mesh FILE]... [--seeds N] [options of Google Benchmark]\n"
      "\n"
      "  --mesh FILE  PLY, OBJ, OFF or STL; may be repeated. Without any: generated creatures of\n"
      "               10,000, 100,000 and 1,000,000 triangles\n"
      "  --seeds N    the only number of seeds to try\n"
      "\n"
      "Benchmarks are named STAGE/MESH[/seeds:N]/(sequential|threads:N)[/delta:MEAN_ARCS], so:\n"
      "  --benchmark_list_tests                             shows them all\n"
      "  --benchmark_filter='^search/.*-1000000/.*threads'  runs some of them\n"
      "  --benchmark_filter=-reference                      runs all but some\n"
      "\n"
      "Exit status: 0, 1 where a benchmark failed, 2 where arguments or files cannot be used.\n"
      "\n",
      stdout);
  std::fflush(stdout);
}

}  // namespace geolloyd
