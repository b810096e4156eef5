# cmake -DTABLE=ja.json -DOUTPUT=file.cpp -P embed_words.cmake
# Writes a C++ file that holds the table's lines, each a string of its own: some compilers allow no long ones.
file(READ ${TABLE} text)
string(REPLACE "\n" ")~\",\n    R\"~(" lines "${text}")
file(WRITE ${OUTPUT} "#include <cstddef>

namespace gg {

extern const char* const kJapaneseLines[] = {
    R\"~(${lines})~\"};
extern const std::size_t kJapaneseLineCount = sizeof(kJapaneseLines) / sizeof(kJapaneseLines[0]);

} // namespace gg
")
