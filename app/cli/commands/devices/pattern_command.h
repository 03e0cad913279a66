// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "backend/pattern/motors/motor_model.h"

#include <optional>
#include <string>

namespace teleta::cli {

/// teleta pattern: lists, shows, samples, converts, checks and plays patterns of the bracelet.
class PatternCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "pattern"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    CLI::App* m_list = nullptr;
    CLI::App* m_show = nullptr;
    CLI::App* m_render = nullptr;
    CLI::App* m_convert = nullptr;
    CLI::App* m_check = nullptr;
    CLI::App* m_play = nullptr;

    [[nodiscard]] core::Expected<void> list() const;
    [[nodiscard]] core::Expected<void> show() const;
    [[nodiscard]] core::Expected<void> render() const;
    [[nodiscard]] core::Expected<void> convert() const;
    [[nodiscard]] core::Expected<void> check() const;
    [[nodiscard]] core::Expected<void> play() const;
    /// Of --motors; assumed ones without it.
    [[nodiscard]] core::Expected<pattern::MotorProfiles> motors() const;

    /// What m_pattern names, with its motors helped up if that is asked.
    [[nodiscard]] core::Expected<pattern::Pattern> helped(const pattern::MotorProfiles& profiles) const;

    std::string m_pattern;
    std::string m_outPath;
    std::string m_motorsPath;
    std::string m_device = "usb";
    std::optional<double> m_measure_s;
    double m_rate_Hz = 200.0;
    std::optional<double> m_convertRate_Hz;
    bool m_predicted = false;
    bool m_overdrive = false;
    bool m_json = false;
};

} // namespace teleta::cli
