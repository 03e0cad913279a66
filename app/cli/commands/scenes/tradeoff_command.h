// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

#include <string>
#include <vector>

namespace teleta::cli {

/// `teleta tradeoff`: measures what accuracy costs in time, here and now.
class TradeoffCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "tradeoff"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    std::vector<std::string> m_names;
    bool m_list = false;
    bool m_json = false;
    std::string m_outFolder;
    double m_largestSpread_percent = 25.0;
};

} // namespace teleta::cli
