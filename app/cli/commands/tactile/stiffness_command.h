// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "backend/stiffness/stiffness_estimator.h"

#include <string>
#include <vector>

namespace teleta::cli {

/// teleta stiffness: stiffness and material of the object that a joint's log has touched.
class StiffnessCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "stiffness"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    [[nodiscard]] core::Expected<std::vector<stiffness::JointSample>> readLog() const;
    [[nodiscard]] core::Error explain(stiffness::Refusal refusal,
                                      const std::vector<stiffness::JointSample>& log) const;

    stiffness::TouchSettings m_settings;
    std::string m_logPath;
    std::string m_method = stiffness::toString(stiffness::Method::regression);
    std::vector<double> m_window_Nm;
    double m_linkHalfThickness_m = 0.0;
    bool m_json = false;
};

} // namespace teleta::cli
