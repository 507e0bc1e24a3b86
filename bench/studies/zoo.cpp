// Remeshes the zoo (bench/zoo) and judges each part by what is true of it:
// zoo [--vertices N] [NAME...] prints tables in Markdown.
// zoo --write FOLDER [NAME...] writes the parts as PLY instead.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "bench/zoo/judge.h"
#include "bench/zoo/zoo.h"
#include "core/course/remesh_warnings.h"
#include "core/formats/mesh_io.h"

namespace geolloyd {
namespace {

struct Arguments {
  std::size_t vertices = 2000;
  std::filesystem::path folder;
  std::vector<std::string> names;
};

struct Row {
  zoo::Part part;
  zoo::Verdict verdict;
};

std::size_t number(const std::string& word) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || value < 4) {
    throw std::invalid_argument(word + " is no number of vertices");
  }
  return value;
}

Arguments read_arguments(int argc, char** argv) {
  Arguments arguments;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool has_value = i + 1 < words.size();
    if (words[i] == "--write" && has_value) {
      arguments.folder = words[++i];
    } else if (words[i] == "--vertices" && has_value) {
      arguments.vertices = number(words[++i]);
    } else {
      arguments.names.push_back(words[i]);
    }
  }
  return arguments;
}

std::string words_of(const std::vector<RemeshWarning>& warnings) {
  std::string words;
  for (const RemeshWarning& warning : warnings) {
    words += (words.empty() ? "" : ", ") + std::string(name_of(warning.flaw));
  }
  return words;
}

std::string text(const char* format, double number) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, number);
  return buffer.data();
}

void print(const Row& row) {
  const auto& [part, v] = row;
  const std::string kept = v.kept                           ? text("%.1f", 100 * *v.kept)
                           : part.is_soft && v.features > 0 ? "false ones"
                                                            : "";
  const std::string rim = v.least_on_rim ? std::to_string(*v.least_on_rim) : "";
  const std::string angle =
      text("%.1f", v.smallest_angle) +
      (part.truth.forced_angle < 20 ? text(" of %.1f", part.truth.forced_angle) : "");
  std::printf(
      "| %s | %s | %zu | %zu | %s | %.1f | %.1f | %.3f | %.2f | %s | %s | %zu%s | %s | %.2f |\n",
      part.name.c_str(), part.kind.c_str(), part.mesh.triangle_count(), v.vertices, angle.c_str(),
      100 * v.valence_6, 100 * v.valence_6_between, 100 * v.volume_error, 100 * v.hausdorff,
      kept.c_str(), rim.c_str(), v.parts, v.is_sound() ? "" : ", BAD", words_of(v.warnings).c_str(),
      v.seconds);
}

struct Measure {
  const char* name;
  std::function<bool(const Row&)> is_met;
};

std::vector<Measure> measures() {
  const auto whole = [](const Row& row) {
    return static_cast<double>(row.verdict.vertices) <=
           1.05 * static_cast<double>(row.verdict.wanted);
  };
  return {
      {"a manifold of the true topology, all triangles with an area",
       [](const Row& row) { return row.verdict.is_sound(); }},
      {"no triangles that go through each other",
       [](const Row& row) { return row.verdict.crossings == 0; }},
      {"at most 5 % more vertices than wanted", whole},
      {"six neighbours at 85 % of the vertices",
       [](const Row& row) { return row.verdict.valence_6 >= 0.85; }},
      {"smallest angle 20 degrees, or three quarters of what the part forces",
       [](const Row& row) { return row.verdict.smallest_angle >= row.verdict.wanted_angle; }},
      {"volume within 1 %",
       [](const Row& row) { return std::abs(row.verdict.volume_error) <= 0.01; }},
      {"Hausdorff within 1 % of the diagonal",
       [](const Row& row) { return row.verdict.hausdorff <= 0.01; }},
      {"99 % of the sharp edges kept",
       [](const Row& row) { return row.verdict.kept.value_or(1) >= 0.99; }},
      {"6 vertices on each rim longer than an edge",
       [](const Row& row) { return row.verdict.least_on_rim.value_or(6) >= 6; }},
      {"no features on soft shapes",
       [](const Row& row) { return !row.part.is_soft || row.verdict.features == 0; }},
      {"no warning where all figures are good",
       [](const Row& row) { return !row.verdict.is_good() || row.verdict.warnings.empty(); }},
      {"at most 10 CPU seconds", [](const Row& row) { return row.verdict.seconds <= 10; }},
      {"a warning where volume is off by 2 % or Hausdorff 3 %",
       [](const Row& row) { return !row.verdict.is_bad() || !row.verdict.warnings.empty(); }},
  };
}

void print_summary(const std::vector<Row>& rows) {
  std::printf("| of %zu parts | parts | not |\n|---|---|---|\n", rows.size());
  for (const Measure& measure : measures()) {
    std::string missed;
    std::size_t met = 0;
    for (const Row& row : rows) {
      if (measure.is_met(row)) {
        ++met;
      } else {
        missed += (missed.empty() ? "" : ", ") + row.part.name;
      }
    }
    std::printf("| %s | %zu | %s |\n", measure.name, met, missed.c_str());
  }
}

void print_rows(const std::vector<Row>& rows) {
  std::puts(
      "\n| part | kind | triangles | vertices | angle | v6, % | between, % | volume off, % | "
      "Hausdorff, % | edges kept, % | on a rim | parts | warnings | CPU s |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  for (const Row& row : rows) print(row);
}

std::vector<zoo::Cage> asked_for(const std::vector<std::string>& names) {
  std::vector<zoo::Cage> cages = zoo::zoo();
  for (const std::string& name : names) {
    const bool is_known = std::any_of(cages.begin(), cages.end(),
                                      [&](const zoo::Cage& cage) { return cage.name == name; });
    if (!is_known) throw std::invalid_argument(name + " is no part of the zoo");
  }
  std::erase_if(cages, [&](const zoo::Cage& cage) {
    return !names.empty() && std::find(names.begin(), names.end(), cage.name) == names.end();
  });
  return cages;
}

void write_parts(const std::vector<zoo::Cage>& cages, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const zoo::Cage& cage : cages) write(folder / (cage.name + ".ply"), cage.make().mesh);
}

std::vector<Row> judge_parts(const std::vector<zoo::Cage>& cages, std::size_t vertices) {
  std::vector<Row> rows;
  for (const zoo::Cage& cage : cages) {
    std::fprintf(stderr, "%s\n", cage.name.c_str());
    zoo::Part part = cage.make();
    const zoo::Verdict verdict = judge(part, vertices);
    rows.push_back({std::move(part), verdict});
  }
  return rows;
}

void run(const Arguments& arguments) {
  const std::vector<zoo::Cage> cages = asked_for(arguments.names);
  if (!arguments.folder.empty()) {
    write_parts(cages, arguments.folder);
    return;
  }
  const std::vector<Row> rows = judge_parts(cages, arguments.vertices);
  print_summary(rows);
  print_rows(rows);
}

}  // namespace
}  // namespace geolloyd

int main(int argc, char** argv) {
  try {
    geolloyd::run(geolloyd::read_arguments(argc, argv));
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "zoo: %s\n", e.what());
    return 2;
  }
}
