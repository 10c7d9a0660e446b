// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "monitor/front/doctor/checks.h"

namespace {

using galilean::front::Check;

void tell(const Check& check) {
  std::printf("%-8s %-17s %s\n", check.ok ? "ok" : "problem", check.what.c_str(),
              check.told.c_str());
  if (!check.ok) std::printf("%-8s %-17s → %s\n", "", "", check.to_do.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  using namespace galilean::front;
  int port = 8080, domain = -1;
  galilean::CommandLine app(
      "Checks whether this machine can run a team; the exit code is 0 if it can.",
      "galilean doctor");
  app.option("--port", port, "Port of the page").between(1, 65535).show_default();
  galilean::add_domain_option(app, domain);
  if (const auto code = app.parse(argc, argv)) return *code;
  bool well = true;
  for (const auto& check :
       {check_programs(), check_page(), check_pseudo_terminals(), check_shared_memory(),
        check_port(port), check_loopback(), check_multicast(), check_dds(domain), check_devices(),
        check_messages(port)}) {
    tell(check);
    well = well && check.ok;
  }
  return well ? 0 : 1;
}
