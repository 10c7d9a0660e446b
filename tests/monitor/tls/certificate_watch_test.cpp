// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/tls/certificate_watch.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/private_file.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

class CertificateWatchTest : public testing::Test {
 protected:
  CertificateWatchTest() {
    replace(files.certificate);
    replace(files.key);
  }
  static void replace(const std::filesystem::path& file) {
    EXPECT_TRUE(replace_private_file(file, "text"));
  }

  const TemporaryFolder folder;
  const CertificateFiles files = own_certificate(folder.path());
};

TEST_F(CertificateWatchTest, WhatIsThereAtTheBeginningIsNotNew) {
  CertificateWatch watch(files);
  for (int look = 0; look < 3; ++look) EXPECT_FALSE(watch.is_renewed());
}

TEST_F(CertificateWatchTest, ANewPairIsNoticedOnceAndNotBeforeBothRest) {
  CertificateWatch watch(files);
  replace(files.key);
  EXPECT_FALSE(watch.is_renewed()) << "the certificate may follow";
  replace(files.certificate);
  EXPECT_FALSE(watch.is_renewed());
  EXPECT_TRUE(watch.is_renewed());
  EXPECT_FALSE(watch.is_renewed());
}

TEST_F(CertificateWatchTest, AFileThatIsGoneForAMomentIsNoticedWhenItIsBack) {
  CertificateWatch watch(files);
  std::filesystem::remove(files.certificate);
  EXPECT_FALSE(watch.is_renewed());
  EXPECT_TRUE(watch.is_renewed()) << "whoever reads it says that it is not there";
  replace(files.certificate);
  EXPECT_FALSE(watch.is_renewed());
  EXPECT_TRUE(watch.is_renewed());
}

}  // namespace
}  // namespace galilean::monitor
