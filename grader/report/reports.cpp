#include "report/reports.hpp"

#include "report/html.hpp"
#include "report/junit.hpp"
#include "report/results_json.hpp"
#include "report/write_file.hpp"

namespace ggrade::report {

void writeReports(const std::filesystem::path& folder, const Result& result, Reveal reveal,
                  std::launch how) {
  makeFolder(folder);
  const Pages pages = resultPages(result, reveal, how);
  const std::string json = resultsJson(result, reveal), xml = junit(result);
  writeFile(folder / "index.html", pages.index);
  writeFile(folder / "student.html", pages.student);
  writeFile(folder / "junit.xml", xml);
  writeFile(folder / "results.json", json); // last: where it stands, everything stands
}

} // namespace ggrade::report
