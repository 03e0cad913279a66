// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/cost/cost_measuring.h"

#include "backend/cost/cost_file.h"
#include "widgets/base/background.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace teleta::console {

CostMeasuring::CostMeasuring(MakeLadders makeLadders, QString file, const cost::MeasureSettings& settings,
                             QObject* parent)
    : QObject(parent)
    , m_makeLadders(std::move(makeLadders))
    , m_ladders(m_makeLadders())
    , m_file(std::move(file))
    , m_settings(settings) {
    read();
}

CostMeasuring::~CostMeasuring() {
    // Nobody is told any more.
    if (m_run)
        m_run->cancelled.store(true, std::memory_order_relaxed);
}

void CostMeasuring::read() {
    if (m_file.isEmpty())
        return;
    base::runInBackground(
        this,
        [path = m_file]() -> core::Expected<std::vector<cost::LadderCost>> {
            if (!QFileInfo::exists(path))
                return std::vector<cost::LadderCost>{};
            return cost::readCostFile(path.toStdString());
        },
        [this](core::Expected<std::vector<cost::LadderCost>> costs) {
            if (!costs) {
                emit failed(tr("The saved costs cannot be read."),
                            QString::fromStdString(core::describe(costs.error())));
                return;
            }
            // What was measured meanwhile is newer.
            std::erase_if(*costs,
                          [this](const cost::LadderCost& cost) { return costOf(cost.ladder) != nullptr; });
            if (costs->empty())
                return;
            m_costs.insert(m_costs.end(), costs->begin(), costs->end());
            emit changed();
        });
}

const cost::LadderCost* CostMeasuring::costOf(const std::string& ladder) const {
    const auto found = std::ranges::find(m_costs, ladder, &cost::LadderCost::ladder);
    return found == m_costs.end() ? nullptr : &*found;
}

cost::MeasureProgress CostMeasuring::progress() {
    if (!m_run)
        return {};
    m_run->progress.update();
    return m_run->progress.front();
}

void CostMeasuring::start(const std::string& ladder) {
    if (m_run)
        return;
    std::vector<cost::Ladder> chosen;
    std::ranges::copy_if(m_ladders, std::back_inserter(chosen),
                         [&](const cost::Ladder& one) { return ladder.empty() || one.name == ladder; });
    if (chosen.empty())
        return;
    m_run = std::make_shared<Run>();
    m_run->ladder = ladder;
    emit runningChanged();
    base::runInBackground(
        this,
        [run = m_run, chosen = std::move(chosen), settings = m_settings]() mutable {
            settings.goOn = [&run](const cost::MeasureProgress& now) {
                run->progress.back() = now;
                run->progress.publish();
                return !run->cancelled.load(std::memory_order_relaxed);
            };
            return cost::measureLadders(chosen, settings);
        },
        [this](core::Expected<cost::Measurement> measured) { finish(std::move(measured)); });
}

void CostMeasuring::cancel() {
    if (!m_run)
        return;
    m_run->cancelled.store(true, std::memory_order_relaxed);
    emit runningChanged();
}

bool CostMeasuring::isMeasuring(const std::string& ladder) const {
    return m_run && (m_run->ladder.empty() || m_run->ladder == ladder);
}

bool CostMeasuring::isCancelled() const {
    return m_run && m_run->cancelled.load(std::memory_order_relaxed);
}

void CostMeasuring::finish(core::Expected<cost::Measurement> measured) {
    m_run.reset();
    if (!measured)
        emit failed(tr("The jobs could not be measured."),
                    QString::fromStdString(core::describe(measured.error())));
    else
        keep(std::move(measured->ladders));
    emit runningChanged();
}

void CostMeasuring::keep(std::vector<cost::LadderCost> costs) {
    // A ladder that was ended half-way would hide the whole one of before.
    std::erase_if(costs, [this](const cost::LadderCost& cost) {
        const cost::LadderCost* before = costOf(cost.ladder);
        return before != nullptr && before->rungs.size() > cost.rungs.size();
    });
    if (costs.empty())
        return;
    for (cost::LadderCost& cost : costs) {
        std::erase_if(m_costs, [&](const cost::LadderCost& old) { return old.ladder == cost.ladder; });
        m_costs.push_back(std::move(cost));
    }
    emit changed();
    if (m_file.isEmpty())
        return;
    base::runInBackground(
        this,
        [path = m_file, all = m_costs] {
            QDir().mkpath(QFileInfo(path).absolutePath());
            return cost::writeCostFile(all, path.toStdString());
        },
        [this](const core::Expected<void>& written) {
            if (!written)
                emit failed(tr("The costs cannot be saved."),
                            QString::fromStdString(core::describe(written.error())));
        });
}

} // namespace teleta::console
