#pragma once
/// \file
/// Unpacks archives in the sandbox and without it.

#include "intake/unpack.hpp"
#include "intake_archives.hpp"
#include "intake_samples.hpp"

#include <gmock/gmock.h>

namespace ggrade::intake {

class ArchiveUpload : public testing::TestWithParam<sandbox::Isolation> {
protected:
  /// Unpacks an upload with this content into a new `into`.
  Unpacked unpackBytes(const std::string& name, const std::string& bytes) {
    std::filesystem::remove_all(into);
    // Nobody but the owner may read an upload; nor enter the folder above.
    const std::filesystem::path path = folder.write(name, bytes);
    std::filesystem::permissions(path, std::filesystem::perms(0600));
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0700));
    return unpack(uploadOf(path), kWanted, into, GetParam());
  }

  TemporaryFolder folder;
  const std::filesystem::path into = folder.path() / "into";
};

#define ARCHIVE_SUITE(name)                                                                        \
  class name : public ArchiveUpload {};                                                            \
  INSTANTIATE_TEST_SUITE_P(                                                                        \
      With, name, testing::Values(sandbox::Isolation::bwrap, sandbox::Isolation::none),            \
      [](const auto& parameter) {                                                                  \
        return parameter.param == sandbox::Isolation::bwrap ? "bwrap" : "none";                    \
      })

} // namespace ggrade::intake
