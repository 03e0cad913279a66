// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_subject.h"

#include "backend/sweep/subjects.h"

#include <QDir>
#include <QFileInfo>
#include <QString>

#include <algorithm>
#include <set>

namespace teleta::sweep {

namespace {

constexpr std::uint64_t kMostCheckedCells = 10'000;

} // namespace

core::Error atKeyOf(const SweepPlan& plan, std::uint64_t cell, core::Error error) {
    const SweepAxis::Key* blamed = nullptr;
    std::string settings;
    const std::vector<std::size_t> place = plan.placeOf(cell);
    for (std::size_t i = 0; i < plan.axes.size(); ++i)
        for (std::size_t k = 0; k < plan.axes[i].keys.size(); ++k) {
            const SweepAxis::Key& key = plan.axes[i].keys[k];
            const std::string leaf = key.name.substr(key.name.rfind('.') + 1);
            if (blamed == nullptr ||
                (error.message.find(leaf) != std::string::npos &&
                 error.message.find(blamed->name.substr(blamed->name.rfind('.') + 1)) == std::string::npos))
                blamed = &key;
            settings += (settings.empty() ? "" : ", ") + key.name + " = " +
                        core::plainText(plan.axes[i].values[place[i]][k]);
        }
    if (blamed == nullptr)
        return error;
    error.message += " (" + settings + ")";
    error.where = blamed->place;
    return error;
}

core::Expected<void> checkCells(const SweepPlan& plan, bool checked,
                                const std::function<core::Expected<void>(std::uint64_t cell)>& check) {
    if (checked)
        return {};
    // The cells in which one axis alone is not at its first value.
    std::vector<std::uint64_t> single{0};
    std::uint64_t step = 1;
    for (std::size_t i = plan.axes.size(); i-- > 0;) {
        for (std::uint64_t value = 1; value < plan.axes[i].values.size(); ++value)
            single.push_back(value * step);
        step *= plan.axes[i].values.size();
    }
    for (const std::uint64_t cell : single)
        if (const auto tried = check(cell); !tried)
            return core::Unexpected(atKeyOf(plan, cell, tried.error()));
    const std::set<std::uint64_t> done(single.begin(), single.end());
    for (std::uint64_t cell = 0; cell < std::min(plan.cells(), kMostCheckedCells); ++cell)
        if (!done.contains(cell))
            if (const auto tried = check(cell); !tried)
                return core::Unexpected(atKeyOf(plan, cell, tried.error()));
    return {};
}

std::string pathBeside(const SweepPlan& plan, const std::string& path) {
    const QDir folder = QFileInfo(QString::fromStdString(plan.file)).dir();
    return QDir::cleanPath(folder.filePath(QString::fromStdString(path))).toStdString();
}

core::Expected<std::unique_ptr<SweepSubject>> makeSubject(SweepPlan& plan, const SubjectSources& sources) {
    switch (plan.kind) {
    case SubjectKind::study:
        return makeStudySubject(plan, sources);
    case SubjectKind::ladder:
        return makeLadderSubject(plan, sources);
    case SubjectKind::scene:
        break;
    }
    return makeSceneSubject(plan, sources);
}

} // namespace teleta::sweep
