// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/threads/latest_exchange.h"
#include "backend/cost/ladder.h"
#include "backend/cost/measurer.h"

#include <QObject>

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace teleta::console {

/// Measures ladders on a pool thread, keeps what was measured, and writes it into a file that the next start
/// reads. Thread: GUI.
class CostMeasuring : public QObject {
    Q_OBJECT

public:
    using MakeLadders = std::function<std::vector<cost::Ladder>()>;

    /// makeLadders: always the same ones, with texts in the language of the moment. file: empty: nothing is
    /// kept.
    CostMeasuring(MakeLadders makeLadders, QString file, const cost::MeasureSettings& settings,
                  QObject* parent = nullptr);
    /// Ends a measuring at its next trial.
    ~CostMeasuring() override;

    [[nodiscard]] const std::vector<cost::Ladder>& ladders() const { return m_ladders; }
    /// Takes the texts of the ladders from a language that was changed.
    void retranslate() { m_ladders = m_makeLadders(); }
    /// Null: it was not measured yet.
    [[nodiscard]] const cost::LadderCost* costOf(const std::string& ladder) const;
    [[nodiscard]] bool isRunning() const { return m_run != nullptr; }
    /// This ladder is among those that are being measured.
    [[nodiscard]] bool isMeasuring(const std::string& ladder) const;
    /// It was told to end, and will at its next trial.
    [[nodiscard]] bool isCancelled() const;
    /// Of the newest trial; empty names before the first one.
    [[nodiscard]] cost::MeasureProgress progress();

    /// Measures this ladder, or all for an empty name. Nothing happens while another measuring runs.
    void start(const std::string& ladder);
    /// What was finished until then is kept.
    void cancel();

signals:
    /// The kept costs are others than before.
    void changed();
    /// A measuring begins, is told to end, or has ended.
    void runningChanged();
    void failed(const QString& what, const QString& details);

private:
    struct Run {
        std::string ladder; ///< empty: all
        std::atomic<bool> cancelled{false};
        core::LatestExchange<cost::MeasureProgress> progress;
    };

    void read();
    void finish(core::Expected<cost::Measurement> measured);
    void keep(std::vector<cost::LadderCost> costs);

    MakeLadders m_makeLadders;
    std::vector<cost::Ladder> m_ladders;
    QString m_file;
    cost::MeasureSettings m_settings;
    std::vector<cost::LadderCost> m_costs;
    std::shared_ptr<Run> m_run;
};

} // namespace teleta::console
