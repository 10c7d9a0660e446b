// SPDX-License-Identifier: BSD-3-Clause
// The page's tests read the catalogs that these robots publish, as far as the page looks at them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "robot/components.h"
#include "tests/robot/own_schemas.h"

namespace galilean::robot {
namespace {

/// Components that have a role, without their words.
std::string for_the_page(const Registry& registry) {
  Catalog kept;
  std::ranges::copy_if(
      registry.catalog().components, std::back_inserter(kept.components), [](const auto& each) {
        return std::ranges::any_of(
            each.attributes, [](const auto& attribute) { return attribute.role != Role::kNone; });
      });
  nlohmann::json json = kept;
  for (auto& component : json["components"]) {
    component.erase("help");
    for (auto& attribute : component["attributes"]) attribute.erase("help");
  }
  return json.dump(1) + "\n";
}

/// GALILEAN_WRITE_FIXTURES=1 writes the file instead.
void expect_fixture(const std::string& name, const std::string& text) {
  const std::string path = GALILEAN_SOURCE_DIR "/web/tests/fixture/" + name;
  if (std::getenv("GALILEAN_WRITE_FIXTURES") != nullptr) std::ofstream(path) << text;
  std::ostringstream found;
  found << std::ifstream(path).rdbuf();
  EXPECT_EQ(found.str(), text) << path << " is not what robots publish: run this test with "
                               << "GALILEAN_WRITE_FIXTURES=1 in the environment";
}

TEST(PageFixture, IsTheCatalogThatRobotsPublish) {
  Registry registry;
  add_components(registry);
  expect_fixture("catalog.json", for_the_page(registry));
}

TEST(PageFixture, IsTheCatalogOfSchemasOfOnesOwn) {
  Registry registry;
  add_own_schemas(registry);
  expect_fixture("own_catalog.json", for_the_page(registry));
}

}  // namespace
}  // namespace galilean::robot
