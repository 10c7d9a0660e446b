// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/keys/security_documents.h"

#include <array>
#include <ctime>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/secure_folder.h"

namespace galilean::monitor {
namespace {

constexpr const char* kBegin =
    "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
    "<dds xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
    "xsi:noNamespaceSchemaLocation=\"https://www.omg.org/spec/DDS-SECURITY/20170901/";

/// Returns every domain that can be secured.
std::string domains() {
  return "<domains><id_range><min>0</min><max>" + std::to_string(kLastSecuredDomain) +
         "</max></id_range></domains>\n";
}

/// Messages are in whatever partition their writers choose. Without topics an element is left out,
/// because the schema asks for one.
void write_topics(std::ostream& out, std::string_view what,
                  const std::vector<std::string>& topics) {
  if (topics.empty()) return;
  out << "<" << what << "><topics>\n";
  for (const auto& topic : topics) out << "<topic>" << topic << "</topic>\n";
  out << "</topics><partitions><partition>*</partition></partitions></" << what << ">\n";
}

}  // namespace

std::string document_time(std::int64_t since_1970_s) {
  const auto time = static_cast<std::time_t>(since_1970_s);
  std::tm parts{};
  std::array<char, 64> text{};
  if (gmtime_r(&time, &parts) == nullptr) return std::to_string(since_1970_s);
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

std::string governance_xml() {
  return std::string(kBegin) + "omg_shared_ca_governance.xsd\">\n" +
         "<domain_access_rules><domain_rule>\n" + domains() +
         "<allow_unauthenticated_participants>false</allow_unauthenticated_participants>\n"
         "<enable_join_access_control>true</enable_join_access_control>\n"
         "<discovery_protection_kind>ENCRYPT</discovery_protection_kind>\n"
         "<liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>\n"
         "<rtps_protection_kind>SIGN</rtps_protection_kind>\n"
         "<topic_access_rules><topic_rule>\n"
         "<topic_expression>*</topic_expression>\n"
         "<enable_discovery_protection>true</enable_discovery_protection>\n"
         "<enable_liveliness_protection>true</enable_liveliness_protection>\n"
         "<enable_read_access_control>true</enable_read_access_control>\n"
         "<enable_write_access_control>true</enable_write_access_control>\n"
         "<metadata_protection_kind>NONE</metadata_protection_kind>\n"
         "<data_protection_kind>ENCRYPT</data_protection_kind>\n"
         "</topic_rule></topic_access_rules>\n"
         "</domain_rule></domain_access_rules>\n</dds>\n";
}

std::string permissions_xml(const Grant& grant) {
  std::ostringstream out;
  out << kBegin << "omg_shared_ca_permissions.xsd\">\n"
      << "<permissions><grant name=\"" << grant.name << "\">\n"
      << "<subject_name>" << grant.subject << "</subject_name>\n"
      << "<validity><not_before>" << document_time(grant.from_s) << "</not_before><not_after>"
      << document_time(grant.until_s) << "</not_after></validity>\n"
      << "<allow_rule>\n"
      << domains();
  write_topics(out, "publish", grant.rights.writes);
  write_topics(out, "subscribe", grant.rights.reads);
  out << "</allow_rule>\n<default>DENY</default>\n</grant></permissions>\n</dds>\n";
  return out.str();
}

}  // namespace galilean::monitor
