// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/options.h"

#include "app/cli/base/command_io.h"

#include <QCoreApplication>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <system_error>
#include <utility>

namespace teleta::cli {

namespace {

struct ValidatorText {
    Q_DECLARE_TR_FUNCTIONS(ValidatorText)
};

std::string misfit(const std::string& text, const QString& wanted) {
    return ValidatorText::tr("%1 is given, %2 is expected")
        .arg(QString::fromStdString(text), wanted)
        .toStdString();
}

CLI::Validator numberThat(const std::function<bool(double)>& accepted, const QString& wanted) {
    CLI::Validator validator(std::string{});
    validator.operation([accepted, wanted](std::string& text) -> std::string {
        double value = 0.0;
        return CLI::detail::lexical_cast(text, value) && std::isfinite(value) && accepted(value)
                   ? std::string()
                   : misfit(text, wanted);
    });
    return validator;
}

} // namespace

CLI::Option* addFlag(CLI::App& app, const char* name, bool& value, const QString& help) {
    return app.add_flag(name, value, help.toStdString());
}

void refuse(const char* option, const QString& text) {
    throw CLI::ValidationError(option, text.toStdString());
}

CLI::App& CommandGroup::addPart(CLI::App& app, const char* name, const QString& summary,
                                std::function<core::Expected<void>()> run) {
    app.require_subcommand(1);
    CLI::App* part = app.add_subcommand(name, summary.toStdString());
    part->callback([this, run = std::move(run)] { m_run = run; });
    return *part;
}

CLI::Validator finite() {
    return numberThat([](double) { return true; }, ValidatorText::tr("a number"));
}

CLI::Validator nonZero() {
    return numberThat([](double value) { return value != 0.0; }, ValidatorText::tr("a number other than 0"));
}

CLI::Validator positive() {
    return numberThat([](double value) { return value > 0.0; }, ValidatorText::tr("a number above 0"));
}

CLI::Validator between(double lower, double upper) {
    return numberThat(
        [lower, upper](double value) { return value >= lower && value <= upper; },
        ValidatorText::tr("a number from %1 to %2").arg(forPeople(lower, 6), forPeople(upper, 6)));
}

CLI::Validator seed() {
    CLI::Validator validator(std::string{});
    validator.operation([](std::string& text) -> std::string {
        std::uint64_t value = 0;
        const char* end = text.data() + text.size();
        const auto [stop, code] = std::from_chars(text.data(), end, value);
        return code == std::errc{} && stop == end
                   ? std::string()
                   : misfit(text, ValidatorText::tr("a whole number from 0 to %1")
                                      .arg(std::numeric_limits<std::uint64_t>::max()));
    });
    return validator;
}

} // namespace teleta::cli
