// Any bytes as the name of an upload, a file or a student: what is shown is UTF-8 without control
// characters, what becomes a folder stays one, and nothing invisible makes a student another one.
#include "require.hpp"

#include "gradebook/look_alike.hpp"
#include "intake/layouts.hpp"
#include "intake/names.hpp"
#include "report/text.hpp"

#include <cstdint>

namespace {

void requireShowable(const std::string& text) {
  require(!text.empty() && ggrade::intake::isUtf8(text) && !ggrade::intake::hasControl(text));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ggrade;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string name = intake::decodeOrEscape(bytes);
  require(intake::isUtf8(name));
  requireShowable(intake::displayName(name));
  const std::string folder = intake::folderName(name, name);
  require(!folder.empty() && folder.size() <= intake::kLongestFolderName);
  require(folder.find_first_of("/.\\") == folder.npos && folder[0] != '-');
  intake::archiveSuffix(name);
  intake::isOtherArchive(name);
  require(intake::splitNumber(name).name.size() <= name.size());
  if (const auto moodle = intake::parseMoodle(name))
    require(!moodle->identifier.empty() &&
            moodle->identifier.find_first_not_of("0123456789") == std::string::npos);
  if (const auto canvas = intake::parseCanvas(name)) require(!canvas->user.empty());

  const std::string skeleton = gradebook::skeleton(name);
  require(intake::isUtf8(skeleton));
  require(gradebook::skeleton("\u200B" + name) == skeleton);
  require(gradebook::skeleton("  " + name + "\u3000") == skeleton);
  const std::string visible = gradebook::visible(name);
  requireShowable(visible);
  require(report::sanitize(visible) == visible);
  gradebook::skeleton(bytes); // whatever it is
  return 0;
}
