// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_folder.h"

#include "backend/core/data/input_file.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/sweep/sweep_figure.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QString>
#include <QStringList>
#include <QSysInfo>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <thread>

namespace teleta::sweep {

namespace {

constexpr int kSweepFormat = 1;

struct SweepFolderText {
    Q_DECLARE_TR_FUNCTIONS(SweepFolderText)
};

const char* kindName(SubjectKind kind) {
    return kind == SubjectKind::scene ? "scene" : kind == SubjectKind::study ? "study" : "ladder";
}

/// The content of sweep.json; with results also how far it has come.
nlohmann::ordered_json documentOf(const SweepFolder& sweep, const SweepPlan& plan,
                                  const SweepResults* results) {
    const QFileInfo info(QString::fromStdString(plan.file));
    // One that comes with the program has a name and no file.
    const std::string file =
        (plan.file.starts_with(":/") ? info.completeBaseName() : info.fileName()).toStdString();
    nlohmann::ordered_json document{
        {"format", kSweepFormat},
        {"file", file},
        {kindName(plan.kind), plan.subject},
        {"app_version", sweep.version},
        {"repeat", "teleta sweep " + file + " --out FOLDER" + (sweep.frames ? " --frames npz" : "")},
        {"cells", plan.cells()},
        {"first_seed", plan.firstSeed},
        {"last_seed", plan.lastSeed},
        {"runs", plan.runs()},
        {"frames", sweep.frames},
        {"machine",
         {{"system", QSysInfo::prettyProductName().toStdString()},
          {"architecture", QSysInfo::currentCpuArchitecture().toStdString()},
          {"cores", std::thread::hardware_concurrency()}}}};
    if (results != nullptr) {
        document["done"] = results->done;
        document["failed"] = results->failed;
        document["measures"] = results->measures;
    }
    if (plan.kind == SubjectKind::ladder) {
        document["rungs"] = nlohmann::ordered_json::array();
        for (const SweepAxis& axis : plan.axes)
            for (const std::vector<core::TomlValue>& value : axis.values)
                document["rungs"].push_back(core::plainText(value[0]));
    }
    document["text"] = plan.text;
    document["source"] = sweep.source;
    return document;
}

core::Expected<void> writeSweepJson(const SweepFolder& sweep, const SweepPlan& plan,
                                    const SweepResults* results) {
    return core::writeFile(sweep.folder + "/sweep.json", documentOf(sweep, plan, results).dump(2) + "\n");
}

/// The first line that differs, as "line N: OLD, now NEW".
QString difference(const std::string& old, const std::string& now) {
    const QStringList before = QString::fromStdString(old).split(QLatin1Char('\n'));
    const QStringList after = QString::fromStdString(now).split(QLatin1Char('\n'));
    for (qsizetype i = 0; i < std::max(before.size(), after.size()); ++i) {
        const QString was = i < before.size() ? before[i].trimmed() : QString();
        const QString is = i < after.size() ? after[i].trimmed() : QString();
        if (was != is)
            return SweepFolderText::tr("line %1 was \"%2\" and is \"%3\"").arg(i + 1).arg(was, is);
    }
    return SweepFolderText::tr("only the spaces differ");
}

core::Unexpected notTheSame(const std::string& folder, const QString& what) {
    return core::failed(core::ErrorKind::refused,
                        SweepFolderText::tr("the folder holds results of another sweep: %1").arg(what),
                        SweepFolderText::tr("another folder, or --restart, which throws these results away"),
                        {folder});
}

/// Removes the results of a sweep, and nothing else.
core::Expected<void> removeResults(const std::string& folder) {
    QDir dir(QString::fromStdString(folder));
    bool removed = true;
    for (const char* part : {"parts", "frames", "figures"}) {
        QDir inner(dir.filePath(QLatin1String(part)));
        removed = (!inner.exists() || inner.removeRecursively()) && removed;
    }
    for (const char* file : {"runs.csv", "cells.csv", "frames.csv", "sweep.json"})
        removed = (!dir.exists(QLatin1String(file)) || dir.remove(QLatin1String(file))) && removed;
    if (removed)
        return {};
    return core::failed(core::ErrorKind::ioFailed, SweepFolderText::tr("earlier results cannot be removed"),
                        {}, {folder});
}

} // namespace

core::Expected<void> SweepFolder::open(const SweepPlan& plan, bool restart) const {
    const QDir dir(QString::fromStdString(folder));
    const bool isSweep = dir.exists(QStringLiteral("sweep.json"));
    if (isSweep && restart) {
        TELETA_CHECK(removeResults(folder));
    } else if (isSweep) {
        SweepPlan earlierPlan;
        TELETA_TRY(const SweepFolder earlier, read(folder, earlierPlan));
        if (earlierPlan.text != plan.text)
            return notTheSame(folder, difference(earlierPlan.text, plan.text));
        if (earlier.source != source)
            return notTheSame(
                folder,
                SweepFolderText::tr("what it runs has changed, %1").arg(difference(earlier.source, source)));
        if (earlier.version != version)
            return notTheSame(
                folder, SweepFolderText::tr("they are of version %1, this is %2")
                            .arg(QString::fromStdString(earlier.version), QString::fromStdString(version)));
        if (earlier.frames != frames)
            return notTheSame(folder, earlier.frames ? SweepFolderText::tr("they have frames")
                                                     : SweepFolderText::tr("they have no frames"));
        return {};
    } else if (dir.exists() && !dir.isEmpty()) {
        return core::failed(core::ErrorKind::refused, SweepFolderText::tr("the folder holds other files"),
                            SweepFolderText::tr("a new or empty folder, or one of a sweep"), {folder});
    }
    TELETA_CHECK(core::makeFolder(folder + "/parts"));
    return writeSweepJson(*this, plan, nullptr);
}

core::Expected<SweepResults> SweepFolder::merge(const SweepPlan& plan) const {
    TELETA_TRY(SweepResults results, mergeParts(plan, folder, frames));
    TELETA_CHECK(writeSweepFigures(plan, results, folder + "/figures"));
    TELETA_CHECK(writeSweepJson(*this, plan, &results));
    return results;
}

core::Expected<SweepFolder> SweepFolder::read(const std::string& folder, SweepPlan& plan) {
    const std::string path = folder + "/sweep.json";
    TELETA_TRY(const std::string text, core::readFile(path));
    const nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
    const auto textAt = [&](const char* key) {
        const auto value = document.is_object() ? document.find(key) : document.end();
        return value != document.end() && value->is_string() ? value->get<std::string>() : std::string();
    };
    if (!document.is_object() || document.value("format", nlohmann::json()) != kSweepFormat)
        return core::failed(core::ErrorKind::badInput, SweepFolderText::tr("this describes no sweep"),
                            SweepFolderText::tr("a file that teleta sweep has written"), {path});
    SweepFolder sweep;
    sweep.folder = folder;
    sweep.source = textAt("source");
    sweep.version = textAt("app_version");
    const auto frames = document.find("frames");
    sweep.frames = frames != document.end() && *frames == true;
    TELETA_TRY(plan, parseSweepPlan(textAt("text"), textAt("file")));
    const auto rungs = document.find("rungs");
    if (plan.kind == SubjectKind::ladder && plan.axes.empty() && rungs != document.end() &&
        rungs->is_array()) {
        SweepAxis axis{{{"rung", {path}}}, {}, false};
        for (const nlohmann::json& rung : *rungs)
            axis.values.push_back(
                {core::TomlValue(rung.is_string() ? rung.get<std::string>() : rung.dump())});
        plan.axes.push_back(std::move(axis));
    }
    return sweep;
}

} // namespace teleta::sweep
