// Files and options that cannot be used, or look as if they could not: one line and exit status 2
// with nothing written, or a result. tests/formats/mesh_io_test.cpp has what is wrong inside one
// format, and cuts every format at every byte.
#include <map>
#include <string>
#include <vector>

#include "core/formats/mesh_io.h"
#include "tests/support/program.h"

namespace geolloyd {
namespace {

const char* const accepted = nullptr;

struct OddFile {
  const char* name;
  const char* file;
  std::string bytes;
  const char* complaint;  // or `accepted`

  friend void PrintTo(const OddFile& row, std::ostream* out) { *out << row.name; }
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string windows(const std::string& text) {
  return replaced(text, "\n", "\r\n");
}

const std::string obj_text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string off_text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string ply_text =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string stl_text =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\nendsolid s\n";

std::string utf16(const std::string& text, bool is_big_endian = false) {
  std::string bytes = is_big_endian ? "\xfe\xff" : "\xff\xfe";
  for (const char c : text) bytes += is_big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

// A triangle behind a title that begins so.
std::string binary_stl(std::string title) {
  title.resize(80, '\0');
  const std::string zero(4, '\0');
  const std::string one("\0\0\x80\x3f", 4);
  std::string bytes = title + std::string("\1\0\0\0", 4) + zero + zero + one;
  for (const std::string& corner : {zero + zero, one + zero, zero + one}) bytes += corner + zero;
  return bytes + std::string(2, '\0');
}

std::string long_line() {
  std::string line = "v 0 0 0";
  for (int i = 0; i < 500'000; ++i) line += " 1";
  return line + obj_text.substr(obj_text.find('\n')) + std::string(1'000'000, '#');
}

std::string large_polygon() {
  std::string text = "OFF\n1000 1 0\n";
  std::string face = "1000";
  for (int i = 0; i < 1000; ++i) {
    text += std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    face += ' ' + std::to_string(i);
  }
  return text + face + "\n";
}

// clang-format off
const std::vector<OddFile> odd_files = {
    {"EmptyPly", "a.ply", "", "the file is empty"},
    {"EmptyObj", "a.obj", "", "the file is empty"},
    {"EmptyOff", "a.off", "", "the file is empty"},
    {"EmptyStl", "a.stl", "", "the file is empty"},
    {"OnlyBlankLines", "a.obj", "\n\n \n", "the file ends without a vertex"},
    {"OnlyZeros", "a.stl", std::string(84, '\0'), "the file ends without a vertex"},
    {"NoFaces", "a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "a point cloud has no surface"},
    {"OnlyDegenerateTriangles", "a.off", replaced(off_text, "3 0 1 2", "3 0 0 1"), "nothing to relax"},
    {"NanInObj", "a.obj", replaced(obj_text, "v 1", "v nan"), "line 2: a coordinate is not finite"},
    {"NanInPly", "a.ply", replaced(ply_text, "\n1 0 0", "\n1 NaN 0"), "line 11: a coordinate is not finite"},
    {"InfInOff", "a.off", replaced(off_text, "\n1 0", "\n-inf 0"), "line 4: a coordinate is not finite"},
    {"InfInStl", "a.stl", replaced(stl_text, "vertex 1", "vertex inf"), "line 5: a coordinate is not finite"},
    {"BeyondDouble", "a.obj", replaced(obj_text, "v 1", "v 1e999"), "line 2: "},
    {"TooLarge", "a.obj", replaced(obj_text, "v 1", "v 1e76"), "line 2: a coordinate is beyond 1e75; scale"},
    {"TooSmall", "a.obj", "v 0 0 0\nv 1e-76 0 0\nv 0 1e-76 0\nf 1 2 3\n", "smaller than 1e-75; scale it up"},
    {"IndexZeroInObj", "a.obj", replaced(obj_text, "f 1", "f 0"), "line 4: expected a vertex index"},
    {"IndexOneTooLarge", "a.off", replaced(off_text, "1 2\n", "1 3\n"), "vertex index 3 is out of range"},
    {"IndexNegative", "a.ply", replaced(ply_text, "1 2\n", "1 -1\n"), "vertex index -1 is out of range"},
    {"IndexLargestOf31Bits", "a.obj", replaced(obj_text, "2 3\n", "2 2147483648\n"), "vertex index 2147483648 is out"},
    {"IndexLargestOf32Bits", "a.obj", replaced(obj_text, "2 3\n", "2 4294967295\n"), "vertex index 4294967295 is out"},
    {"IndexThatWrapsTo3", "a.obj", replaced(obj_text, "2 3\n", "2 4294967299\n"), "vertex index 4294967299 is out"},
    {"IndexOf64Bits", "a.off", replaced(off_text, "1 2\n", "1 9223372036854775807\n"), "9223372036854775807 is out"},
    {"IndexBeyond64Bits", "a.off", replaced(off_text, "1 2\n", "1 18446744073709551618\n"), "expected a vertex index"},
    {"CountsThatTheFileDoesNotKeep", "a.ply", replaced(ply_text, "face 1", "face 4294967295"), "4294967295 rows of element 'face' are promised"},
    {"CountsBeyond64Bits", "a.off", replaced(off_text, "3 1 0", "99999999999999999999 1 0"), "expected the number of vertices"},
    {"DecimalComma", "a.obj", replaced(obj_text, "v 1", "v 1,5"), "line 2: expected a coordinate, found '1,5'"},
    {"Gzip", "a.ply", "\x1f\x8b\x08 and so on", "the compressed file is damaged: "},
    {"Zstandard", "a.ply", "\x28\xb5\x2f\xfd and so on", "the compressed file is damaged: "},
    {"PlyNamedStl", "a.stl", ply_text + std::string(100, '\n'), "the file ends here, but its header promises"},
    {"ObjNamedPly", "a.ply", obj_text, "line 1: expected 'ply', found 'v'"},
    {"NoExtension", "a", obj_text, "unknown extension ''"},
    {"OtherExtension", "a.ply.xz", ply_text, "unknown extension '.xz'"},
    {"NoExtensionBeforeThatOfGzip", "a.gz", ply_text, "unknown extension ''"},
    {"UnpackedButNamedGzip", "a.ply.gz", ply_text, accepted},
    {"Utf16", "a.obj", utf16(obj_text), "a.obj: byte 0: the file is UTF-16 text; save it as UTF-8"},
    {"Utf16OfTheOtherOrder", "a.obj", utf16(obj_text, true), "the file is UTF-16 text; save it as UTF-8"},
    {"Utf16InOff", "a.off", utf16(windows(off_text)), "the file is UTF-16 text; save it as UTF-8"},
    {"Utf16InPly", "a.ply", utf16(ply_text), "the file is UTF-16 text; save it as UTF-8"},
    {"Utf16InStl", "a.stl", utf16(stl_text), "the file is UTF-16 text; save it as UTF-8"},
    {"ByteOrderMarkInBinaryStl", "a.stl", binary_stl("\xff\xfes"), accepted},
    {"WindowsLineEndsInPly", "a.ply", windows(ply_text), accepted},
    {"WindowsLineEndsInObj", "a.obj", windows(obj_text), accepted},
    {"WindowsLineEndsInOff", "a.off", windows(off_text), accepted},
    {"WindowsLineEndsInStl", "a.stl", windows(stl_text), accepted},
    {"OldMacLineEnds", "a.ply", replaced(ply_text, "\n", "\r"), accepted},
    {"OffOfOneLine", "a.off", replaced(off_text, "\n", " "), accepted},
    {"OffWithoutItsFirstWord", "a.off", off_text.substr(4), accepted},
    {"PlyOfOneStrip", "a.ply", replaced(replaced(ply_text, "element face", "element tristrips"), "uchar int", "char int"), accepted},
    {"NoLastLineEnd", "a.off", off_text.substr(0, off_text.size() - 1), accepted},
    {"ByteOrderMark", "a.off", "\xef\xbb\xbf" + off_text, accepted},
    {"Tabs", "a.obj", replaced(obj_text, " ", "\t \t"), accepted},
    {"LongLines", "a.obj", long_line(), accepted},
    {"LargePolygon", "a.off", large_polygon(), accepted},
    {"CapitalExtension", "A.PLY", ply_text, accepted},
    {"NameWithBlanks", "a b  c .ply", ply_text, accepted},
    {"NameWithOtherAlphabets", "schöne Grüße, 表面.ply", ply_text, accepted},
    {"NameThatIsNotUtf8", "not \xff utf-8.ply", ply_text, accepted},
    {"NameOfTwoLines", "two\nlines.ply", ply_text, accepted},
    {"NameWithQuotesAndDollar", "\"$HOME\" `x`.ply", ply_text, accepted},
    {"NameOfTwoLinesOfABadFile", "two\nlines.ply", obj_text, "two?lines.ply: line 1"},
};
// clang-format on

class OddFiles : public testing::TestWithParam<OddFile> {};

TEST_P(OddFiles, BecomeWhatTheTableSays) {
  const TemporaryFolder folder;
  const OddFile& row = GetParam();
  const std::string file = '\'' + folder.write(row.file, row.bytes).string() + '\'';
  const fs::path out = folder.path() / "out";
  const Outcome relaxed = geolloyd_with("relax " + file + " -k 1 -o " + out.string());
  const Outcome informed = geolloyd_with("info " + file);
  if (row.complaint == accepted) {
    EXPECT_EQ(relaxed.status, 0) << relaxed.text;
    EXPECT_EQ(informed.status, 0) << informed.text;
    EXPECT_TRUE(fs::exists(out / "report.json"));
  } else {
    expect_complaint(relaxed, row.complaint);
    EXPECT_FALSE(fs::exists(out));
  }
}

INSTANTIATE_TEST_SUITE_P(All, OddFiles, testing::ValuesIn(odd_files),
                         [](const auto& row) { return std::string(row.param.name); });

// What is left of a file of text may be a smaller mesh: a result, then, or one line.
TEST_F(Program, TruncatedFilesEndInAResultOrOneLine) {
  const Mesh mesh = read(mesh_).mesh;
  std::map<std::string, std::string> files = {{"ascii.ply", ply_text}, {"ascii.stl", stl_text}};
  for (const char* name : {"binary.ply", "binary.stl", "a.obj", "a.off"}) {
    write(folder_.path() / name, mesh);
    files[name] = read_file(folder_.path() / name);
  }
  for (const auto& [name, bytes] : files) {
    const bool is_binary = name.rfind("binary", 0) == 0;
    for (const std::size_t percent : {1U, 50U, 99U}) {
      mesh_ = folder_.write(name, bytes.substr(0, bytes.size() * percent / 100));
      const Outcome outcome = relax("--seeds 4");
      if (is_binary || outcome.status != 0) {
        expect_complaint(outcome, is_binary ? name : "");
        EXPECT_FALSE(fs::exists(out())) << name << " " << percent;
      }
      fs::remove_all(out());
    }
  }
}

struct BadOption {
  const char* name;
  const char* arguments;  // in a folder that holds torus.ply
  const char* complaint;

  friend void PrintTo(const BadOption& row, std::ostream* out) { *out << row.name; }
};

// clang-format off
const BadOption bad_options[] = {
    {"NoSeeds", "relax -o out torus.ply", "how many regions? Give --seeds N"},
    {"ZeroSeeds", "relax -o out -k 0 torus.ply", "--seeds: '0': give a whole number from 1 to 4294967295"},
    {"NegativeSeeds", "relax -o out --seeds -4 torus.ply", "--seeds: '-4'"},
    {"SeedsInWords", "relax -o out --seeds many torus.ply", "--seeds: 'many'"},
    {"HalfASeed", "relax -o out -k 1.5 torus.ply", "--seeds: '1.5'"},
    {"HexadecimalSeeds", "relax -o out -k 0x5 torus.ply", "--seeds: '0x5'"},
    {"SeedsBeyond64Bits", "relax -o out -k 99999999999999999999 torus.ply", "--seeds: '99999999999999999999'"},
    {"MoreSeedsThanNodes", "relax -o out -k 1001 torus.ply", "more seeds (1001) than graph nodes (1000)"},
    {"SeedsTwice", "relax -o out -k 4 --seeds-file x torus.ply", "exclude each other"},
    {"NegativeRandomSeed", "relax -o out -k 4 --random-seed -1 torus.ply", "--random-seed: '-1'"},
    {"NegativeLimit", "relax -o out -k 4 --max-macrosteps -1 torus.ply", "--max-macrosteps: '-1'"},
    {"NegativeImprovement", "relax -o out -k 4 --improve -1 torus.ply", "--improve -1: give a whole number of rounds"},
    {"ImprovementInWords", "relax -o out -k 4 --improve much torus.ply", "--improve much: give a whole number of rounds"},
    {"HalfARoundOfImprovement", "relax -o out -k 4 --improve 1.5 torus.ply", "--improve 1.5: give a whole number of rounds"},
    {"NoSecondsOfImprovement", "relax -o out -k 4 --improve 0s torus.ply", "--improve 0s: give a whole number of rounds, or seconds above 0"},
    {"NegativeSecondsOfImprovement", "relax -o out -k 4 --improve -3s torus.ply", "or seconds above 0"},
    {"EndlessImprovement", "relax -o out -k 4 --improve infs torus.ply", "or seconds above 0"},
    {"ImprovementBeyond32Bits", "relax -o out -k 4 --improve 4294967296 torus.ply", "--improve 4294967296: give"},
    {"ComparedForSeconds", "compare -k 4 --improve 2s torus.ply", "--improve with a limit in seconds"},
    {"FramesOfImprovement", "relax -o out -k 4 --frames f --improve 2 torus.ply", "--frames and --improve exclude each other"},
    {"LimitBeyond32Bits", "relax -o out -k 4 --max-greedy-steps 4294967296 torus.ply", "--max-greedy-steps: '4294967296'"},
    {"NoThreads", "relax -o out -k 4 --threads 0 torus.ply", "--threads: '0': give a whole number from 1 to 1024"},
    {"TooManyThreads", "relax -o out -k 4 --threads 100000 torus.ply", "--threads: '100000'"},
    {"NegativeMemory", "relax -o out -k 4 --memory-limit -1 torus.ply", "--memory-limit: '-1': give a whole number of bytes above 0"},
    {"NoMemory", "relax -o out -k 4 --memory-limit 0 torus.ply", "--memory-limit: '0': give a whole number of bytes above 0"},
    {"HalfAGigabyteOfMemory", "relax -o out -k 4 --memory-limit 1.5G torus.ply", "--memory-limit: '1.5G': give a whole number of bytes above 0"},
    {"MemoryInWords", "relax -o out -k 4 --memory-limit lots torus.ply", "--memory-limit: 'lots': give a whole number of bytes above 0"},
    {"MemoryInUnknownUnits", "relax -o out -k 4 --memory-limit 8Q torus.ply", "--memory-limit: '8Q': give a whole number of bytes above 0"},
    {"MemoryInUnknownLongUnits", "relax -o out -k 4 --memory-limit 8GG torus.ply", "--memory-limit: '8GG': give a whole number of bytes above 0"},
    {"MemoryBeyond64Bits", "relax -o out -k 4 --memory-limit 99999999T torus.ply", "--memory-limit: '99999999T': give a whole number of bytes above 0"},
    {"NoNumberOfSeconds", "relax -o out -k 4 --checkpoint nan torus.ply", "--checkpoint: 'nan': give a number of seconds, 0 or more"},
    {"EndlessSeconds", "relax -o out -k 4 --checkpoint inf torus.ply", "--checkpoint: 'inf'"},
    {"NegativeSeconds", "relax -o out -k 4 --checkpoint -1 torus.ply", "--checkpoint: '-1': give a number of seconds, 0 or more"},
    {"SecondsInWords", "relax -o out -k 4 --checkpoint 5m torus.ply", "--checkpoint: '5m'"},
    {"UnknownGraph", "relax -o out -k 4 --graph cube torus.ply", "cube"},
    {"UnknownOption", "relax -o out -k 4 --frobnicate torus.ply", "--frobnicate"},
    {"TwoMeshes", "relax -o out -k 4 torus.ply torus.ply", "not expected"},
    {"NoOutput", "relax -k 4 torus.ply", "--output"},
    {"EmptyOutput", "relax -k 4 -o '' torus.ply", "--output: empty"},
    {"EmptyPicture", "relax -k 4 -o out --picture '' torus.ply", "--picture: empty"},
    {"EmptyFrames", "relax -k 4 -o out --frames '' torus.ply", "--frames: empty"},
    {"EmptySeedsFile", "relax -k 4 -o out --seeds-file '' torus.ply", "--seeds-file: empty"},
    {"AveragingOfNoField", "relax -o out -k 4 --averaging metric torus.ply", "--averaging: of which tangent field? Give --vfield FILE, or --vfield curvature"},
    {"MetricOfAnotherNorm", "relax -o out -k 4 --vfield f.vfield --norm linf --averaging metric torus.ply", "give pairwise, or --norm geodesic"},
    {"UnknownAveraging", "relax -o out -k 4 --vfield f.vfield --averaging mean torus.ply", "mean"},
    {"EmptyField", "relax -k 4 -o out --vfield '' torus.ply", "--vfield: empty"},
    {"EmptyOutputOfCompare", "compare -k 4 -o '' torus.ply", "--output: empty"},
    {"EmptyOutputOfProfile", "profile -k 4 -o '' torus.ply", "--output: empty"},
    {"EmptyOutputOfBatch", "batch -k 4 -o '' torus.ply", "--output: empty"},
    {"EmptyOutputOfGroundTruth", "ground-truth -k 4 -o '' torus.ply", "--output: empty"},
    {"EmptyOutputOfQuality", "quality -o '' torus.ply", "--output: empty"},
    {"EmptyOriginal", "quality --original '' torus.ply", "--original: empty"},
    {"EmptyOutputOfRender", "render -o '' torus.ply", "--output: empty"},
    {"EmptyOutputOfSubdivide", "subdivide -s midpoint -o '' torus.ply", "--output: empty"},
    {"EmptyMesh", "info ''", "MESH: empty"},
    {"NoSamples", "quality --samples 0 torus.ply", "--samples: '0'"},
    {"NoTurns", "compare -k 4 --turns 0 torus.ply", "--turns: '0'"},
    {"NoThreadsToCompare", "compare -k 4 --threads 1,0 torus.ply", "--threads: '0'"},
    {"NoBatches", "batch -k 4 --batches 0 torus.ply", "--batches: '0'"},
    {"SmallPicture", "render --size 63 -o a.png torus.ply", "--size 63"},
    {"SmallPanels", "render --size 64 --panel mesh --panel mesh --panel mesh --panel mesh -o a.png missing.ply", "--size: too small for 4 panels"},
    {"CaptionNotInUtf8", "render --panel mesh=\xff -o a.png missing.ply", "is not in UTF-8"},
    {"UnknownView", "render --view inside -o a.png torus.ply", "--view inside"},
    {"NoTriangles", "generate torus -o a.ply -t 0", "--triangles: '0'"},
    {"NegativeTriangles", "generate torus -o a.ply -t -5", "--triangles: '-5'"},
    {"TrianglesInScientificNotation", "generate torus -o a.ply -t 1e12", "--triangles: '1e12'"},
    {"TrianglesBeyond32Bits", "generate torus -o a.ply -t 1000000000000", "ask for fewer than"},
    {"UnknownShape", "generate cuboid -o a.ply", "cuboid"},
    {"UnknownFormat", "generate creature -t 100000000 -o a.xyz", "unknown extension '.xyz'"},
    {"MissingFolder", "generate creature -t 100000000 -o no/a.ply", "no/a.ply: cannot write: No such file"},
    {"NoCommand", "", "A subcommand is required"},
    {"UnknownCommand", "frobnicate", "see geolloyd --help"},
    {"MistypedCommand", "relx torus.ply", "no command relx (did you mean relax?): see geolloyd --help"},
    {"MistypedOption", "relax torus.ply -o out -k 4 --tread=2", "no option --tread (did you mean --threads?)"},
    {"MistypedOptionThatIsNeeded", "relax torus.ply -k 4 --outptu out", "no option --outptu (did you mean --output?)"},
    {"MistypedOptionOfTheProgram", "--versoin", "no option --versoin (did you mean --version?)"},
    {"MeshNameForAFolder", "relax torus.ply -k 4 -o out.ply", "--output: 'out.ply' is the name of a mesh file: give that of a folder"},
    {"MeshNameForAFolderOfTables", "batch torus.ply -k 4 -o out.STL", "--output: 'out.STL' is the name of a mesh"},
    {"MeshNameForFrames", "relax torus.ply -k 4 -o out --frames f.obj", "--frames: 'f.obj' is the name of a mesh"},
    {"NoMesh", "relax -o out", "MESH"},
    {"NoVertices", "remesh torus.ply -o r.ply", "how fine? Give --vertices N"},
    {"VerticesAndEdgeLength", "remesh torus.ply -o r.ply -n 100 --edge-length 1",
     "--vertices, --edge-length and --tolerance exclude each other"},
    {"EdgeLengthOfNothing", "remesh torus.ply -o r.ply --edge-length 0",
     "--edge-length: '0': give a number above 0"},
    {"EdgeLengthTooShort", "remesh torus.ply -o r.ply --edge-length 1e-9",
     "edge length 1e-09: the remesh would have more than"},
    {"ToleranceOfNothing", "remesh torus.ply -o r.ply --tolerance 0%",
     "--tolerance: '0%': give a distance above 0, or like 0.5%"},
    {"FeatureAngle", "remesh torus.ply -o r.ply -n 100 --features 181",
     "--features: '181': give auto, off, or an angle"},
    {"FeatureWord", "remesh torus.ply -o r.ply -n 100 --features on",
     "--features: 'on': give auto, off, or an angle"},
    {"FeatureEdgesMissing", "remesh torus.ply -o r.ply -n 100 --feature-edges none.txt",
     "none.txt"},
    {"RemeshOverFeatureEdges", "remesh torus.ply -o torus.ply -n 100", "torus.ply"},
    {"ThreeVertices", "remesh torus.ply -o r.ply -n 3", "--vertices: '3': give a whole number from 4 to 4294967295"},
    {"NegativeVertices", "remesh torus.ply -o r.ply -n -4", "--vertices: '-4'"},
    {"VerticesInWords", "remesh torus.ply -o r.ply -n many", "--vertices: 'many'"},
    {"MoreVerticesThanMemory", "remesh torus.ply -o r.ply -n 4294967295", "torus.ply: needs about"},
    {"NoRemesh", "remesh torus.ply -n 40", "--output is required"},
    {"EmptyRemesh", "remesh torus.ply -n 40 -o ''", "--output: empty"},
    {"EmptyReport", "remesh torus.ply -n 40 -o r.ply --report ''", "--report: empty"},
    {"EmptyIssues", "remesh torus.ply -n 40 -o r.ply --issues ''", "--issues: empty"},
    {"EmptyMap", "remesh torus.ply -n 40 -o r.ply --map ''", "--map: empty"},
    {"EmptyPictureOfRemesh", "remesh torus.ply -n 40 -o r.ply --picture ''", "--picture: empty"},
    {"RemeshOfUnknownFormat", "remesh missing.ply -n 40 -o r.xyz", "unknown extension '.xyz'"},
    {"RemeshWithoutExtension", "remesh missing.ply -n 40 -o remesh", "unknown extension ''"},
    {"SmallPictureOfRemesh", "remesh torus.ply -n 40 -o r.ply --picture r.png --size 63", "--size 63"},
    {"UnknownEngineOfRemesh", "remesh torus.ply -n 40 -o r.ply --engine fast", "fast"},
    {"SeedsAndVerticesToVerify", "verify torus.ply -k 4 -n 40", "--vertices and --seeds exclude each other"},
    {"GraphAndVerticesToVerify", "verify torus.ply -g mixed -n 40", "--vertices and --graph exclude each other"},
    {"FrontierAndVerticesToVerify", "verify torus.ply --frontier heap -n 40", "--vertices and --frontier exclude each other"},
};
// clang-format on

class BadOptions : public Program, public testing::WithParamInterface<BadOption> {};

TEST_P(BadOptions, AreAnsweredWithOneLineBeforeAnyWork) {
  const BadOption& row = GetParam();
  expect_complaint(
      run_shell("cd '" + folder_.path().string() + "' && " GEOLLOYD_PROGRAM " " + row.arguments),
      row.complaint);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

INSTANTIATE_TEST_SUITE_P(All, BadOptions, testing::ValuesIn(bad_options),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_F(Program, NumbersAreDecimal) {
  const Outcome outcome = relax("--seeds 010");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(lines_of(out() / "seeds.csv").size(), 11U);
}

// A graph of triangles has more parts than the mesh where these meet at vertices only.
TEST_F(Program, SaysWhichPartsNeedASeed) {
  mesh_ = folder_.write("bow.off",
                        "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n");
  expect_complaint(relax("--seeds 1 -g triangle"), "2 connected components, and each needs a seed");
  expect_complaint(geolloyd_with("batch -k 1 " + mesh_.string()),
                   "1 seed: first seeds are chosen as triangles, and these are in 2 parts");
  expect_complaint(geolloyd_with("batch -k 3 " + mesh_.string()), "only 2 triangles");
}

}  // namespace
}  // namespace geolloyd
