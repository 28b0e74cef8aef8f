#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace fumage::cli {

/// An option whose value is a whole number in decimal digits, whatever zeros it begins with (to CLI11 itself, 010 is
/// 8).
/// @param value its default, which the help shows where it could be given
CLI::Option* addWhole(
    CLI::App& command, const std::string& name, int& value, int low, int high, const std::string& help);

} // namespace fumage::cli
