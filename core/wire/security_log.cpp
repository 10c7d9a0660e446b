// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/security_log.h"

#include <dds/dds.h>
#include <dds/ddsrt/log.h>

#include <array>
#include <cstdint>
#include <iostream>
#include <mutex>
#include <set>
#include <string_view>

#include "core/visible_text.h"

namespace galilean::wire {
namespace {

/// A stranger can make any number of participants.
constexpr std::size_t kMostTold = 200;

struct Heard {
  std::mutex mutex;
  std::set<std::string> told;
  bool is_joining = false;
  std::string first_line;
};

/// Cyclone may log until the process ends: this is never destroyed.
Heard& heard() {
  static auto* const all = new Heard;
  return *all;
}

struct Meaning {
  std::string_view in_line;
  std::string_view sentence;
};

/// The first that fits counts: what Cyclone says of a grant also tells of its signer's certificate.
constexpr std::array kMeanings{
    Meaning{"SMIME", "the grant is not signed by this team's permissions CA"},
    Meaning{"PKCS7", "the grant is not signed by this team's permissions CA"},
    Meaning{"ertificate revoked",
            "the certificate is revoked; 'galilean team keys add' makes a new member"},
    Meaning{"is revoked", "the member is revoked; 'galilean team keys add' makes a new one"},
    Meaning{"xpired", "a certificate or grant has expired; 'galilean team keys renew' renews it"},
    Meaning{"not yet valid", "a certificate is not valid yet; check the machine's clock"},
    Meaning{"date_start", "a grant is not valid yet; check the machine's clock"},
    Meaning{"CRL", "the list of revoked certificates does not belong to this team's identity CA"},
    Meaning{"issuer certificate",
            "the certificate is not from this team's identity CA; ask for keys of this team"},
    Meaning{"self signed", "the certificate is not from this team's identity CA"},
    Meaning{"self-signed", "the certificate is not from this team's identity CA"},
    Meaning{"trusted", "the certificate is not from this team's identity CA"},
    Meaning{"signature failure", "the certificate is not from this team's identity CA"},
    Meaning{"ubject name", "the grant is for another member than the certificate"},
    Meaning{"Non secure", "it has no keys; start it with --secure"},
    Meaning{"key values mismatch", "the private key belongs to another certificate"},
};

/// Is called by Cyclone, on any thread.
void hear(void*, const dds_log_data_t* data) {
  constexpr std::uint32_t kFailure = DDS_LC_ERROR | DDS_LC_FATAL;
  if ((data->priority & (kFailure | DDS_LC_WARNING)) == 0) return;
  std::string line(data->message, data->size);
  while (!line.empty() && line.back() == '\n') line.pop_back();
  Heard& all = heard();
  const std::lock_guard lock(all.mutex);
  if (all.is_joining) {
    if (all.first_line.empty() && (data->priority & kFailure) != 0) all.first_line = line;
    return;
  }
  if (all.told.size() > kMostTold || !all.told.insert(stranger_of(line)).second) return;
  std::cerr << (all.told.size() > kMostTold ? "galilean: Cyclone refuses more than is told here\n"
                                            : "galilean: DDS Security: " + refusal_of(line) + '\n');
}

}  // namespace

std::string refusal_of(const std::string& line) {
  for (const auto& meaning : kMeanings)
    if (line.find(meaning.in_line) != line.npos)
      return std::string(meaning.sentence) + " (" + visible(line) + ")";
  return visible(line);
}

std::string stranger_of(const std::string& line) {
  constexpr std::string_view kUnsecured = "Non secure remote ";
  if (!line.starts_with(kUnsecured)) return line;
  // "writer a:b:c:d is not allowed.": a GUID's first three numbers are its participant's.
  const auto guid = line.find(' ', kUnsecured.size());
  const auto entity = line.rfind(':');
  if (guid == line.npos || entity == line.npos || entity < guid) return line;
  return std::string(kUnsecured) + line.substr(guid, entity - guid);
}

void listen_to_cyclone() {
  dds_set_log_sink(hear, nullptr);
}

JoiningLog::JoiningLog() {
  Heard& all = heard();
  {
    const std::lock_guard lock(all.mutex);
    all.is_joining = true;
    all.first_line.clear();
  }
  listen_to_cyclone();
}

JoiningLog::~JoiningLog() {
  Heard& all = heard();
  const std::lock_guard lock(all.mutex);
  all.is_joining = false;
}

std::string JoiningLog::first_line() const {
  Heard& all = heard();
  const std::lock_guard lock(all.mutex);
  return all.first_line;
}

}  // namespace galilean::wire
