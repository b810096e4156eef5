// fuzz_seeds FOLDER: writes archives of every kind there, for fuzz_unpack to start from.
#include "../hostile/intake_archives.hpp"

#include <filesystem>
#include <fstream>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  int count = 0;
  const auto write = [&](const std::string& bytes) {
    std::ofstream(folder / ("seed" + std::to_string(count++)), std::ios::binary) << bytes;
  };
  write(zipOf({{"hw/", "", 0, 3, 040755},
               {"hw/floor.cpp", "int a;"},
               {.name = "hw/mirror.vert", .bytes = "text text text", .deflated = true},
               {"hw\\\x95\x5C.frag", "x", 0, 0},
               {"link", "/etc", 0, 3, 0120777},
               {"\u5F71", "", 0x800},
               {"secret", "0123456789abcdef", 1},
               {"__MACOSX/x", ""}}));
  write(overlappingZip(3, 1000));
  const std::string tar = tarOf({{"hw/", "", '5'},
                                 {"hw/floor.cpp", "int a;"},
                                 {"hw/FLOOR.cpp", "b"},
                                 {"../x", "c"},
                                 {"link", "", '2', -1, "/etc"},
                                 {"hard", "", '1', -1, "hw/floor.cpp"},
                                 {"pipe", "", '6'}});
  for (const Compression kind : {Compression::none, Compression::gzip, Compression::bzip2,
                                 Compression::xz, Compression::zstd})
    write(compressed(tar, kind));
  return 0;
}
