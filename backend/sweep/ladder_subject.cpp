// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/failure.h"
#include "backend/cost/cost_result.h"
#include "backend/cost/one_opencv_thread.h"
#include "backend/sweep/subjects.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace teleta::sweep {

namespace {

struct LadderSweepText {
    Q_DECLARE_TR_FUNCTIONS(LadderSweep)
};

std::string rungOf(const CellSettings& settings) {
    const auto found = std::ranges::find(settings, "rung", [](const auto& setting) { return setting.first; });
    return found == settings.end() ? std::string() : core::plainText(found->second);
}

class LadderWorker : public SweepWorker {
public:
    explicit LadderWorker(const cost::Ladder& ladder)
        : m_ladder(ladder) {}

    core::Expected<RunMeasures> run(const SweepPlan& plan, std::uint64_t cell, std::uint64_t seed,
                                    const std::function<void(const scene_run::LabelledFrame&)>&) override {
        if (m_rungs.empty()) {
            TELETA_TRY(m_rungs, m_ladder.makeRungs());
        }
        const std::string name = rungOf(plan.settingsOf(cell));
        const auto rung = std::ranges::find(m_rungs, name, &cost::Rung::name);
        if (rung == m_rungs.end())
            return core::failed(core::ErrorKind::badInput, LadderSweepText::tr("there is no such rung"));
        cost::Trial trial(static_cast<std::size_t>(seed));
        rung->run(trial);
        RunMeasures measures;
        const std::vector<double>& errors = trial.errors();
        const double error =
            std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
        if (std::isfinite(error))
            measures.emplace_back("error", error);
        measures.emplace_back("time_s", trial.time_s());
        measures.emplace_back("taken_away", trial.takenAway());
        return measures;
    }

private:
    cost::Ladder m_ladder;
    std::vector<cost::Rung> m_rungs;
};

class LadderSubject : public SweepSubject {
public:
    explicit LadderSubject(cost::Ladder ladder)
        : m_ladder(std::move(ladder)) {}

    [[nodiscard]] std::unique_ptr<SweepWorker> makeWorker() const override {
        return std::make_unique<LadderWorker>(m_ladder);
    }
    [[nodiscard]] std::string source() const override { return m_ladder.name; }

private:
    cost::Ladder m_ladder;
    cost::OneOpenCvThread m_oneThread; ///< a time is that of one core
};

} // namespace

core::Expected<std::unique_ptr<SweepSubject>> makeLadderSubject(SweepPlan& plan,
                                                                const SubjectSources& sources) {
    QStringList known;
    for (const cost::Ladder& ladder : sources.ladders)
        known << QString::fromStdString(ladder.name);
    const auto ladder = std::ranges::find(sources.ladders, plan.subject, &cost::Ladder::name);
    if (ladder == sources.ladders.end())
        return core::failed(
            core::ErrorKind::badInput,
            LadderSweepText::tr("there is no ladder \"%1\"").arg(QString::fromStdString(plan.subject)),
            LadderSweepText::tr("one of: %1").arg(known.join(QStringLiteral(", "))), {plan.file});
    TELETA_TRY(std::vector<cost::Rung> rungs, ladder->makeRungs());
    // The limit has no error to sweep over.
    std::erase_if(rungs, [](const cost::Rung& rung) { return rung.name == cost::kLimitName; });
    if (plan.axes.empty()) {
        SweepAxis all{{{"rung", {plan.file}}}, {}, false};
        for (const cost::Rung& rung : rungs)
            all.values.push_back({core::TomlValue(rung.name)});
        plan.axes.push_back(std::move(all));
    }
    QStringList names;
    for (const cost::Rung& rung : rungs)
        names << QString::fromStdString(rung.name);
    for (const SweepAxis& axis : plan.axes)
        for (const SweepAxis::Key& key : axis.keys)
            if (key.name != "rung")
                return core::failed(
                    core::ErrorKind::badInput,
                    LadderSweepText::tr("unknown key \"%1\"").arg(QString::fromStdString(key.name)),
                    LadderSweepText::tr("rung"), key.place);
    TELETA_CHECK(checkCells(plan, sources.checked, [&](std::uint64_t cell) -> core::Expected<void> {
        const QString rung = QString::fromStdString(rungOf(plan.settingsOf(cell)));
        if (names.contains(rung))
            return {};
        return core::failed(core::ErrorKind::badInput,
                            LadderSweepText::tr("there is no rung \"%1\"").arg(rung),
                            LadderSweepText::tr("one of: %1").arg(names.join(QStringLiteral(", "))));
    }));
    return std::make_unique<LadderSubject>(*ladder);
}

} // namespace teleta::sweep
