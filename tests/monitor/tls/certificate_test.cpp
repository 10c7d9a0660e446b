// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/tls/certificate.h"

#include <gmock/gmock.h>
#include <openssl/pem.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>

#include "monitor/server/tls/tls_door.h"
#include "monitor/tls/openssl.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string pem_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class OwnCertificate : public testing::Test {
 protected:
  void SetUp() override {
    const auto made = ensure_own_certificate(files);
    ASSERT_TRUE(made) << made.error().message;
  }
  openssl::Certificate read() const {
    const auto text = pem_of(files.certificate);
    const openssl::Bio memory(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
    return openssl::Certificate(PEM_read_bio_X509(memory.get(), nullptr, nullptr, nullptr));
  }

  const TemporaryFolder folder;
  const CertificateFiles files = own_certificate(folder / "data");
};

TEST_F(OwnCertificate, IsMadeOnceWithAKeyForItsOwnerAlone) {
  struct stat status {};
  ASSERT_EQ(stat(files.key.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600U);
  const auto first = fingerprint_of(files.certificate);
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ(first.value().size(), 32 * 3 - 1U);
  ASSERT_TRUE(ensure_own_certificate(files));
  EXPECT_EQ(fingerprint_of(files.certificate).value(), first.value());
  const auto door = TlsDoor::open(files);
  EXPECT_TRUE(door) << door.error().message;
}

TEST_F(OwnCertificate, IsForThisMachineAndInTheDaysAroundNow) {
  const auto certificate = read();
  ASSERT_TRUE(certificate);
  EXPECT_EQ(X509_check_host(certificate.get(), "localhost", 0, 0, nullptr), 1);
  EXPECT_EQ(X509_check_ip_asc(certificate.get(), "127.0.0.1", 0), 1);
  EXPECT_EQ(X509_check_ip_asc(certificate.get(), "::1", 0), 1);
  EXPECT_NE(X509_check_host(certificate.get(), "evil.example", 0, 0, nullptr), 1);
  EXPECT_LT(X509_cmp_current_time(X509_get0_notBefore(certificate.get())), 0);
  EXPECT_GT(X509_cmp_current_time(X509_get0_notAfter(certificate.get())), 0);
  const openssl::Key key(X509_get_pubkey(certificate.get()));
  EXPECT_EQ(X509_verify(certificate.get(), key.get()), 1) << "it is signed by itself";
}

TEST_F(OwnCertificate, OneThatIsDamagedIsNotOverwritten) {
  std::ofstream(files.certificate) << "no certificate";
  const auto made = ensure_own_certificate(files);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("has no certificate in PEM"));
  EXPECT_THAT(made.error().message, HasSubstr("remove it"));
  EXPECT_EQ(pem_of(files.certificate), "no certificate");
  EXPECT_FALSE(fingerprint_of(files.certificate));
  EXPECT_FALSE(TlsDoor::open(files));
}

TEST_F(OwnCertificate, AnothersKeyOpensNoDoor) {
  const auto other = own_certificate(folder / "other");
  ASSERT_TRUE(ensure_own_certificate(other));
  const auto door = TlsDoor::open({files.certificate, other.key});
  ASSERT_FALSE(door);
  EXPECT_THAT(door.error().message, HasSubstr(other.key.string()));
}

TEST(Fingerprint, IsReadAsPeopleCopyIt) {
  std::string wanted, plain;
  for (int i = 0; i < 32; ++i) {
    wanted += i > 0 ? ":AB" : "AB";
    plain += "ab";
  }
  for (const auto& text : {wanted, plain, "AB " + plain.substr(2)}) {
    const auto read = read_fingerprint(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(read.value(), wanted);
  }
  for (const auto& text : {std::string(), plain.substr(1), plain + "ab", "xx" + plain.substr(2)})
    EXPECT_FALSE(read_fingerprint(text)) << text;
}

}  // namespace
}  // namespace galilean::monitor
