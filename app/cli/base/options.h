// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/standard_streams.h"
#include "backend/core/error.h"

#include <QString>

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace teleta::cli {

/// Adds an option, or an argument when its name has no dashes, with a translated help. type: stands for its
/// value in the help; null: CLI11's name of the type. A text may be "-", see acceptDash().
template <typename Value>
CLI::Option* addOption(CLI::App& app, const char* name, Value& value, const QString& help,
                       const char* type = nullptr) {
    CLI::Option* option = app.add_option(name, value, help.toStdString());
    if constexpr (std::is_same_v<Value, std::string> || std::is_same_v<Value, std::vector<std::string>>)
        acceptDash(*option, name, type == nullptr ? "" : type);
    return type == nullptr ? option : option->type_name(type);
}

/// The same with a check of the value; the help shows the default.
template <typename Value>
CLI::Option* addOption(CLI::App& app, const char* name, Value& value, const QString& help,
                       const CLI::Validator& check, const char* type = nullptr) {
    return addOption(app, name, value, help, type)->check(check)->capture_default_str();
}

/// An option that takes one of these words, which the help lists.
template <typename Value>
CLI::Option* addChoice(CLI::App& app, const char* name, Value& value, const QString& help,
                       const std::vector<std::string>& words) {
    return addOption(app, name, value, help)
        ->type_name(CLI::detail::join(words, "|"))
        ->check(CLI::IsMember(words).description(""));
}

CLI::Option* addFlag(CLI::App& app, const char* name, bool& value, const QString& help);

/// Checks for option values; NaN and infinities are refused by all of them.
[[nodiscard]] CLI::Validator finite();
[[nodiscard]] CLI::Validator nonZero();
[[nodiscard]] CLI::Validator positive();
/// lower <= value <= upper.
[[nodiscard]] CLI::Validator between(double lower, double upper);
/// A whole number of 64 bits without a sign, in decimal digits.
[[nodiscard]] CLI::Validator seed();

/// Throws CLI::ValidationError, which ends the program as wrong usage. text: what is wrong with the option.
[[noreturn]] void refuse(const char* option, const QString& text);

/// The base of a command whose work is split into subcommands, one of which has to be given.
class CommandGroup {
public:
    [[nodiscard]] core::Expected<void> run() const { return m_run(); }

protected:
    /// Adds a subcommand and what it does.
    CLI::App& addPart(CLI::App& app, const char* name, const QString& summary,
                      std::function<core::Expected<void>()> run);

private:
    std::function<core::Expected<void>()> m_run;
};

} // namespace teleta::cli
