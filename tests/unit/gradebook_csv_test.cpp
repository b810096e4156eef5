#include "assignment/usage_error.hpp"
#include "gradebook/csv.hpp"

#include <gmock/gmock.h>

#include <random>

namespace ggrade::gradebook {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

std::vector<std::vector<std::string>> table(const Csv& csv) {
  std::vector<std::vector<std::string>> all(csv.rows());
  for (std::size_t row = 0; row < csv.rows(); ++row)
    for (std::size_t column = 0; column < csv.columns(row); ++column)
      all[row].push_back(csv.cell(row, column));
  return all;
}

void expectFault(const std::string& bytes, const std::string& start, const std::string& part) {
  EXPECT_THAT([&] { Csv(bytes, "sheet.csv"); },
              ThrowsMessage<UsageError>(testing::AllOf(StartsWith(start), HasSubstr(part))))
      << bytes.substr(0, 100);
}

TEST(Csv, ReadsQuotedCellsAndAnyLineEnd) {
  const Csv csv("a,\"b \"\"c\"\", d\",\r\n\"two\r\nlines\",e\rf\n\n\"\"", "sheet.csv");
  EXPECT_EQ(table(csv), (std::vector<std::vector<std::string>>{
                            {"a", "b \"c\", d", ""}, {"two\r\nlines", "e"}, {"f"}, {""}, {""}}));
  EXPECT_EQ(csv.line(1), 2u);
  EXPECT_EQ(csv.line(2), 4u) << "one cell has a line end in it";
  EXPECT_EQ(csv.line(4), 6u);
  EXPECT_TRUE(csv.isBlank(3));
  EXPECT_FALSE(csv.isBlank(2));
}

TEST(Csv, TakesTheDelimiterOfTheFirstLine) {
  EXPECT_EQ(Csv("a;b;\"c,d,e\"\n1,5;2;3", "sheet.csv").delimiter(), ';');
  EXPECT_EQ(Csv("a\tb,c\td", "sheet.csv").delimiter(), '\t');
  EXPECT_EQ(Csv("a", "sheet.csv").delimiter(), ',');
  EXPECT_EQ(Csv("a;b;\"c,d,e\"\n1,5;2;3", "sheet.csv").cell(1, 0), "1,5");
}

TEST(Csv, WritesBackTheVeryBytesThatItRead) {
  for (const std::string bytes :
       {"", "\xEF\xBB\xBF",
        "\xEF\xBB\xBF"
        "a,b\r\n",
        "a,\"b\"\nc,d\r\n\n\n e ,\"f\n\"", "a;b;\n;;\n", "a\tb\r\r\n", "\"\"", ",", "\n"})
    EXPECT_EQ(Csv(bytes, "sheet.csv").bytes(), bytes);
}

TEST(Csv, ReplacesOneCellAndNoOtherByte) {
  Csv csv("\xEF\xBB\xBF"
          "id,\"grade\",note\r\n1,\"\", x\n2,-,\"a \"\"b\"\"\"",
          "sheet.csv");
  csv.set(1, 1, "87.5");
  csv.set(2, 1, "5");
  csv.set(2, 2, "fine, \"really\"");
  EXPECT_EQ(csv.cell(2, 2), "fine, \"really\"");
  EXPECT_EQ(csv.bytes(), "\xEF\xBB\xBF"
                         "id,\"grade\",note\r\n1,\"87.5\", x\n2,5,\"fine, \"\"really\"\"\"");
}

TEST(Csv, TheSameTextLeavesTheCellAsItWasWritten) {
  Csv csv("a,\"b\"", "sheet.csv");
  csv.set(0, 1, "c");
  csv.set(0, 1, "b");
  csv.set(0, 0, "a");
  EXPECT_EQ(csv.bytes(), "a,\"b\"");
}

TEST(Csv, KeepsARowWhoseOnlyCellIsEmptied) {
  Csv csv("a\nb", "sheet.csv");
  csv.set(1, 0, "");
  EXPECT_EQ(csv.bytes(), "a\n\"\"");
  EXPECT_EQ(Csv(csv.bytes(), "sheet.csv").rows(), 2u);
}

TEST(Csv, QuotesWhatTheNextReaderCouldMisread) {
  for (const std::string text : {"a,b", "a;b", "a\tb", "a\nb", "a\rb", "\"", " a", "a ",
                                 "\xEF\xBB\xBF"
                                 "a"}) {
    Csv csv("x", "sheet.csv");
    csv.set(0, 0, text);
    EXPECT_EQ(csv.bytes().front(), '"') << text;
    EXPECT_EQ(Csv(csv.bytes(), "sheet.csv").cell(0, 0), text);
  }
}

TEST(Csv, QuotesAnotherTablesDelimiterInTheFirstLineOnly) {
  Csv csv("a;b\n1;2", "sheet.csv");
  csv.set(0, 0, "x,y,z");
  csv.set(1, 0, "5,5");
  EXPECT_EQ(csv.bytes(), "\"x,y,z\";b\n5,5;2");
}

TEST(Csv, NamesTheLineOfABadQuote) {
  expectFault("a,b\n\"c\nd\",e\n1,2,\"open\n\n",
              "sheet.csv: line 4: a quote is never closed (column 3); ", "doubled");
  expectFault("a,\"b\"c,d", "sheet.csv: line 1: text after a closing quote (column 2); ",
              "doubled");
  expectFault("a\nb\"c", "sheet.csv: line 2: a quote in a cell that doesn't start with one", "");
}

TEST(Csv, SaysHowToSaveWhatIsNotUtf8) {
  const std::string remedy = "save it as \"CSV UTF-8\"";
  expectFault("\xFF\xFE"
              "a",
              "sheet.csv: this is UTF-16", remedy);
  expectFault(std::string("a\0,\0", 4), "sheet.csv: this is UTF-16", remedy);
  expectFault("a,b\r\n\r\n1,\x8E\x9F\n", "sheet.csv: line 3: this is not UTF-8", remedy);
}

TEST(Csv, RefusesWhatIsTooLarge) {
  expectFault(std::string(Csv::kMaxBytes + 1, 'a'), "sheet.csv: 67108865 bytes", "64 MiB");
  expectFault(std::string(Csv::kMaxRows + 1, '\n'), "sheet.csv: line 100001: ", "100000 rows");
  expectFault("\n" + std::string(Csv::kMaxColumns, ','), "sheet.csv: line 2: ", "1000 columns");
  EXPECT_EQ(Csv(std::string(Csv::kMaxColumns - 1, ','), "sheet.csv").columns(0), Csv::kMaxColumns);
  EXPECT_EQ(Csv(std::string(Csv::kMaxRows, '\n'), "sheet.csv").rows(), Csv::kMaxRows);
}

TEST(Csv, RefusesCellsThatAreNotThereAndTextThatIsNone) {
  Csv csv("a,b\nc", "sheet.csv");
  EXPECT_THROW(csv.set(1, 1, "x"), std::out_of_range);
  EXPECT_THROW(csv.cell(2, 0), std::out_of_range);
  EXPECT_THROW(csv.set(0, 0, "\xFF"), std::invalid_argument);
  EXPECT_THROW(csv.set(0, 0, std::string("a\0", 2)), std::invalid_argument);
}

// Random tables: what was set is read back, what wasn't is as before, byte for byte.
class RandomTable {
public:
  explicit RandomTable(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return random_() % n; }

  std::string text() {
    static const std::vector<std::string> parts = {
        "a", "影", ",", ";", "\t", "\"", "\n", "\r", "\r\n", " ", "=", "é", "\xEF\xBB\xBF", ""};
    std::string all;
    for (std::size_t i = below(5); i > 0; --i) all += parts[below(parts.size())];
    return all;
  }

  // Cells as they are written, and what stands between them.
  struct Table {
    std::vector<std::vector<std::string>> cells;
    std::vector<std::string> lineEnds;
    std::string start;
    char delimiter;

    std::string bytes() const {
      std::string all = start;
      for (std::size_t row = 0; row < cells.size(); ++row) {
        for (std::size_t column = 0; column < cells[row].size(); ++column)
          all += (column > 0 ? std::string(1, delimiter) : "") + cells[row][column];
        all += lineEnds[row];
      }
      return all;
    }
  };
  Table table() {
    Table all;
    all.start = below(2) ? "\xEF\xBB\xBF" : "";
    all.delimiter = ",;\t"[below(3)];
    const std::size_t rows = 1 + below(6), columns = 2 + below(4);
    for (std::size_t row = 0; row < rows; ++row) {
      all.cells.emplace_back();
      for (std::size_t column = 0; column < columns; ++column)
        all.cells.back().push_back(row == 0 ? "h" : written(text()));
      all.lineEnds.push_back(std::vector<std::string>{"\n", "\r\n", "\r"}[below(3)]);
    }
    if (below(2)) all.lineEnds.back().clear();
    return all;
  }

  std::string written(const std::string& text) {
    std::string cell = csvCell(text);
    if (cell == text && below(3) == 0) cell = '"' + cell + '"';
    return cell;
  }

private:
  std::mt19937 random_;
};

TEST(Csv, RandomCellsAreReadBackAndOtherBytesStay) {
  RandomTable random(20261120);
  for (int i = 0; i < 3000; ++i) {
    const RandomTable::Table table = random.table();
    const Csv original(table.bytes(), "sheet.csv");
    ASSERT_EQ(original.bytes(), table.bytes());
    Csv csv = original;
    RandomTable::Table expected = table;
    for (std::size_t n = random.below(5); n > 0; --n) {
      const std::size_t row = random.below(table.cells.size());
      const std::size_t column = random.below(table.cells[0].size());
      const std::string text = random.text();
      csv.set(row, column, text);
      std::string& cell = expected.cells[row][column];
      cell = csvCell(text, row == 0 ? ",;\t" : std::string_view(&table.delimiter, 1));
      if (table.cells[row][column].starts_with('"') && cell == text) cell = '"' + cell + '"';
      if (original.cell(row, column) == text) cell = table.cells[row][column];
      ASSERT_EQ(Csv(csv.bytes(), "sheet.csv").cell(row, column), text);
    }
    ASSERT_EQ(csv.bytes(), expected.bytes());
    ASSERT_EQ(gradebook::table(Csv(csv.bytes(), "sheet.csv")), gradebook::table(csv));
  }
}

} // namespace
} // namespace ggrade::gradebook
