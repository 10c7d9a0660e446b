// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/command_line/command_line.h"
#include "core/orders/order_signer.h"
#include "core/result.h"

namespace galilean::monitor {

/// Returns the path of the operator's private key in a data folder. Its public half is beside it.
[[nodiscard]] std::filesystem::path operator_key_file(const std::filesystem::path& data_folder);

/// Reads the operator's key in the data folder, and makes it first if it is not there. It is named
/// by the user and the machine. Errors: as load_or_make_key().
[[nodiscard]] Result<SigningKey> open_operator_key(const std::filesystem::path& data_folder);

/// Returns a signer with the key of `key_file`. If that is empty, the key is the operator's in the
/// user's data folder, or there is none and the result is null: robots without --trust obey orders
/// that nobody signed. Errors: the key cannot be read.
[[nodiscard]] Result<std::shared_ptr<OrderSigner>> find_signer(const std::string& key_file);

/// Returns a signer with the key of `key_file`. It shares the numbers of its orders with every
/// process that signs with that file.
[[nodiscard]] std::shared_ptr<OrderSigner> signer_of(SigningKey key,
                                                     const std::filesystem::path& key_file);

/// Adds --key. `note` ends the help, such as "with --direct".
CommandLineOption add_key_option(CommandLine& line, std::string& key_file,
                                 const std::string& note = {});

}  // namespace galilean::monitor
