// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean::expect {

// What comes from programs, recordings and names of files must not break out of its place in a
// report. Invisible characters are shown as their codes.

/// Returns the text as it may stand within an attribute or an element of XML.
[[nodiscard]] std::string xml_text(const std::string& text);
/// Returns ` name="value"`.
[[nodiscard]] std::string xml_attribute(const char* name, const std::string& value);
/// Returns the text as a message of a workflow command of GitHub; in a property, : and , have a
/// meaning, too. Line ends stay, in the commands' code for them.
[[nodiscard]] std::string command_text(const std::string& text, bool property);
/// Returns the text as TAP's description of a test, in which a # would begin a directive, such as
/// one that skips the test.
[[nodiscard]] std::string tap_description(const std::string& text);

}  // namespace galilean::expect
