// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/cost/cost_result.h"
#include "backend/cost/ladder.h"

#include <QCoreApplication>
#include <QString>

namespace teleta::console {

/// What a setting costs and gives, in words. Thread: GUI.
class CostWords {
    Q_DECLARE_TR_FUNCTIONS(CostWords)
public:
    /// Heading of the jobs of a topic.
    [[nodiscard]] static QString topic(cost::Topic topic);

    /// A measured value with its unit; "1" is a share and shown in percent.
    [[nodiscard]] static QString quantity(double value, const QString& unit);

    /// One sentence about a setting, and one each about the next faster and the next more accurate one of
    /// those that no other setting beats; or that another one beats it. Of the limit, and of a setting
    /// without a time or an error, what it is. setting: its name; inUse: it runs now. Empty: it is unknown.
    [[nodiscard]] static QString about(const cost::LadderCost& job, const std::string& setting, bool inUse);

private:
    [[nodiscard]] static QString whyNotCompared(const cost::RungCost& rung);
    [[nodiscard]] static QString difference(double from, double to, const QString& unit);
    [[nodiscard]] static QString comparedWith(const cost::RungCost& other, const cost::RungCost& here,
                                              const QString& unit);
};

} // namespace teleta::console
