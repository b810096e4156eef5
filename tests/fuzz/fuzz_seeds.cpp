// fuzz_seeds FOLDER: writes what each fuzzer can start from to FOLDER/<fuzzer>.
#include "../hostile/intake_archives.hpp"

#include "intake/bundle.hpp"
#include "sample_tape.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace {

namespace fs = std::filesystem;

using Seeds = std::vector<std::string>;

Seeds archives() {
  Seeds all = {zipOf({{"hw/", "", 0, 3, 040755},
                      {"hw/floor.cpp", "int a;"},
                      {.name = "hw/mirror.vert", .bytes = "text text text", .deflated = true},
                      {"hw\\\x95\x5C.frag", "x", 0, 0},
                      {"link", "/etc", 0, 3, 0120777},
                      {"\u5F71", "", 0x800},
                      {"secret", "0123456789abcdef", 1},
                      {"__MACOSX/x", ""}}),
               overlappingZip(3, 1000)};
  const std::string tar = tarOf({{"hw/", "", '5'},
                                 {"hw/floor.cpp", "int a;"},
                                 {"hw/FLOOR.cpp", "b"},
                                 {"../x", "c"},
                                 {"link", "", '2', -1, "/etc"},
                                 {"hard", "", '1', -1, "hw/floor.cpp"},
                                 {"pipe", "", '6'}});
  for (const Compression kind : {Compression::none, Compression::gzip, Compression::bzip2,
                                 Compression::xz, Compression::zstd})
    all.push_back(compressed(tar, kind));
  return all;
}

std::string tape() {
  const std::vector<std::byte> bytes = ggrade::tape::write(sample::reference(0.5F));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string bundle() {
  using namespace ggrade::intake;
  std::ostringstream out;
  writeBundleMark(out);
  writeEntry(out, {.name = "hw/floor.cpp", .size = 6, .bytes = "int a;"});
  writeEntry(out, {.name = "../mirror.vert", .size = 1, .bytes = "x"});
  writeEntry(out, {.kind = Kind::end});
  return out.str();
}

// The first bytes of some choose what the rest is: see the fuzzers.
const std::map<std::string, Seeds> kSeeds = {
    {"fuzz_unpack", archives()},
    {"fuzz_bundle", {bundle()}},
    {"fuzz_csv",
     {std::string("\x01\x01\x02") + "x,a,\"b \"\"c\"\"\"\r\n1,2,3\r\n",
      std::string("\x00\x00\x00", 3) + "\xEF\xBB\xBF" + "a;b\n\n;\"x\ny\"\n"}},
    {"fuzz_worksheet",
     {std::string("\x02\x50\x02") + "okParticipant 1,,100,Yes,\nParticipant 2,5,100.00,No,\n",
      std::string("\x04\x50\x02") + "ok1;;10,0;\r\n3;7;10,0;\r\n",
      std::string("\x03\x50\x00", 3) + "\"One, Student\",1,one,A,3\nx,2,two,A,EX\n",
      std::string("\x05\x50\x00", 3) + "One;Student;1;one;7,5\n"}},
    {"fuzz_overrides",
     {std::string("\x01") + "ada,keep,50,\"a reason\",kim\nada,bonus,-3,r,w\nbob,,12,r,w\n",
      std::string("\x01") + "\xE5\x8F\x82\xE5\x8A\xA0\xE8\x80\x85"
                            "3,gain,\xEF\xBC\x97,r,w\nada,,160,r,w\n",
      std::string("\x00", 1) + "who;points;item;student;reason\na;3;gain;ada;why\n",
      std::string("\x02") + "ada,2026-11-21T12:00+09:00\nbob,2026/11/20 23:59\n",
      std::string("\x03") + "10% per day, at most 50%, 15 min grace",
      std::string("\x04") + "identifier=ID,grade=Note,feedback=Kommentar,max=Bestnote"}},
    {"fuzz_names",
     {"Hanako Yamada_101_assignsubmission_file_floor.cpp", "yamadahanako_LATE_5012_80311_floor.cpp",
      "floor (2).tar.gz", " ad\xE2\x80\x8B\xD0\xB0 ", "\x8A\x77\x90\xB6.zip",
      "Participant\xE3\x80\x80\xEF\xBC\x91\xEF\xBC\x92"}},
    {"fuzz_assignment",
     {R"({"id": "floor", "title": "T", "files": ["floor.cpp"], "files_optional": ["*.vert"],
"parts": [{"id": "mirror", "title": "M", "weight": 0.5, "scene": {},
"todos": [{"id": "mirror.1", "title": "t", "bonus": true}],
"items": [{"id": "mirror.a", "title": "a", "looks_at": "l", "kind": "gain", "points": 60,
"cause": "c", "step": "mirror.1", "output": "map"},
{"id": "mirror.b", "title": "b", "looks_at": "l", "kind": "gain", "points": 40, "cause": "c",
"step": "mirror.1", "after": "mirror.a", "scenes": ["x"]},
{"id": "mirror.k", "title": "k", "looks_at": "l", "kind": "keep", "points": 5, "cause": "c",
"step": "mirror.1"}]}]})"}},
    {"fuzz_record", {R"({"row": {"folder": "s1", "student": "ada", "given": " ada", "name": "ada",
"outcome": "graded", "headline": "h", "reason": "r", "score": 81.5, "bonus": 4, "max_score": 100,
"items": [{"id": "mirror.a", "title": "t", "kind": "keep", "earned": -2, "points": 10,
"judged": true}], "diagnoses": [{"id": "d", "text": "t"}], "remarks": ["2 attempts"],
"refused": ["x: is a symbolic link"], "seconds": 2.5}, "target": "mirror", "seed": 7,
"upload": "u", "grader": "g", "sandbox": "none", "feedback": "f", "run": 1,
"adjustments": []})"}},
    {"fuzz_scene",
     {std::string("\x01") + R"({"camera": {"position": [0, 3, 8], "target": [0, 1, 0], "fov": 0.5,
"near": 1, "far": 15}, "light": {"position": [1, 4, 2]}, "size": [640, 480],
"materials": {"object": {"ambient": [0.1, 0.2, 0.3], "diffuse": [0.4, 0.5, 0.6],
"specular": [0.7, 0.8, 0.9], "shininess": 40}}, "ring": {"radius": 1.5, "count": 3},
"effects": {"mirror": true}, "mesh": "torus_knot"})",
      std::string("\x00", 1) + R"({"materials": ["object"], "scene": {"ring.count":
{"type": "integer", "range": [0, 100], "default": 6, "about": "how many"}}})"}},
    {"fuzz_passes", {std::string("\x05\x01\x10\x00\x01\x07\x02", 7), ""}},
    {"fuzz_tape", {tape()}},
    {"fuzz_trace", {std::string("\x01\x40\x00\x07", 4), std::string("\x00GGT1", 5)}}};

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  for (const auto& [fuzzer, seeds] : kSeeds) {
    const fs::path folder = fs::path(argv[1]) / fuzzer;
    fs::create_directories(folder);
    for (std::size_t i = 0; i < seeds.size(); ++i)
      std::ofstream(folder / ("seed" + std::to_string(i)), std::ios::binary) << seeds[i];
  }
  return 0;
}
