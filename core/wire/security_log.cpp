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
    Meaning{"not started yet", "a grant is not valid yet; check the machine's clock"},
    Meaning{"another identity CA",
            "the certificate is not from this team's identity CA; ask for keys of this team"},
    Meaning{"Timed out", "it did not answer in time, or refuses the keys of this program"},
    Meaning{"CRL", "the list of revoked certificates does not belong to this team's identity CA"},
    Meaning{"issuer certificate",
            "the certificate is not from this team's identity CA; ask for keys of this team"},
    Meaning{"self signed", "the certificate is not from this team's identity CA"},
    Meaning{"self-signed", "the certificate is not from this team's identity CA"},
    Meaning{"trusted", "the certificate is not from this team's identity CA"},
    Meaning{"signature failure", "the certificate is not from this team's identity CA"},
    Meaning{"ubject name", "the grant is for another member than the certificate"},
    Meaning{"key values mismatch", "the private key belongs to another certificate"},
};

/// Requires: the caller holds the lock.
void tell(Heard& all, const std::string& key, const std::string& sentence) {
  if (all.told.size() > kMostTold || !all.told.insert(key).second) return;
  std::cerr << (all.told.size() > kMostTold ? "galilean: Cyclone refuses more than is told here\n"
                                            : "galilean: DDS Security: " + sentence + '\n');
}

/// "handshake (…) failed: (5) Failed": the line before it told of whom, and why.
bool is_told_already(const std::string& line) {
  return line.starts_with("handshake (") && line.ends_with(" Failed");
}

/// Is called by Cyclone, on any thread.
void hear(void*, const dds_log_data_t* data) {
  constexpr std::uint32_t kFailure = DDS_LC_ERROR | DDS_LC_FATAL;
  if ((data->priority & (kFailure | DDS_LC_WARNING)) == 0) return;
  std::string line(data->message, data->size);
  while (!line.empty() && line.back() == '\n') line.pop_back();
  line = ended_part(line);
  if (line.empty() || is_told_already(line)) return;
  Heard& all = heard();
  const std::lock_guard lock(all.mutex);
  if (all.is_joining) {
    if (all.first_line.empty() && (data->priority & kFailure) != 0) all.first_line = line;
    return;
  }
  tell(all, line, refusal_of(line));
}

}  // namespace

std::string refusal_of(const std::string& line) {
  for (const auto& meaning : kMeanings)
    if (line.find(meaning.in_line) != line.npos)
      return std::string(meaning.sentence) + " (" + visible(line) + ")";
  return visible(line);
}

std::string ended_part(const std::string& line) {
  constexpr std::string_view kBegin = "Non secure remote ", kEnd = " is not allowed.";
  std::size_t begin = 0;
  while (std::string_view(line).substr(begin).starts_with(kBegin)) {
    const auto end = line.find(kEnd, begin);
    if (end == line.npos) return {};  // Cyclone's buffer was full
    begin = end + kEnd.size();
  }
  return line.substr(begin);
}

void tell_once(const std::string& sentence) {
  Heard& all = heard();
  const std::lock_guard lock(all.mutex);
  tell(all, sentence, sentence);
}

void end_unended_line() {
  dds_log(DDS_LC_WARNING, __FILE__, __LINE__, "end_unended_line", "\n");
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
