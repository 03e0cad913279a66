// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/folder_owner.h"

#include "backend/core/data/input_file.h"
#include "backend/core/data/json_document.h"
#include "backend/core/data/output_file.h"
#include "backend/core/data/private_files.h"
#include "backend/core/failure.h"
#include "backend/study/store/store_values.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

#include <nlohmann/json.hpp>

namespace teleta::study {

namespace {

using nlohmann::ordered_json;

struct OwnerText {
    Q_DECLARE_TR_FUNCTIONS(StudyStore)
};

QString markOf(const std::string& folder) {
    return QDir(QString::fromStdString(folder)).filePath(QStringLiteral("server-study.json"));
}

} // namespace

core::Expected<void> checkFolderOwner(const std::string& folder, const StudyHead& head) {
    const auto refused = [&](const QString& message) {
        return core::failed(core::ErrorKind::refused, message,
                            OwnerText::tr("a separate folder for each study"), {folder});
    };
    if (QFile::exists(QDir(QString::fromStdString(folder)).filePath(QStringLiteral("study.sqlite"))))
        return refused(OwnerText::tr("this folder already contains a study"));
    const std::string mark = markOf(folder).toStdString();
    const core::Expected<std::string> text = core::readFile(mark);
    if (!text && text.error().kind == core::ErrorKind::notFound)
        return {};
    TELETA_CHECK(text);
    try {
        const ordered_json json = ordered_json::parse(*text);
        if (json.at("created_utc").get<std::string>() != timeText(head.created).toStdString() ||
            json.at("seed").get<std::string>() != std::to_string(head.seed))
            return refused(OwnerText::tr("this folder belongs to another study, on %1")
                               .arg(QString::fromStdString(json.at("server").get<std::string>())));
    } catch (const ordered_json::exception&) {
        return core::failed(core::ErrorKind::badInput,
                            OwnerText::tr("the file does not say which study the folder belongs to"),
                            OwnerText::tr("server, created_utc and seed of a study"), {mark});
    }
    return {};
}

core::Expected<void> ownFolder(const std::string& folder, const StudyHead& head,
                               const std::string& shownName) {
    TELETA_CHECK(checkFolderOwner(folder, head));
    if (QFile::exists(markOf(folder)))
        return {};
    const core::PrivateFiles forOwner;
    TELETA_CHECK(core::makeFolder(folder));
    const ordered_json mark{{"server", shownName},
                            {"created_utc", timeText(head.created).toStdString()},
                            {"seed", std::to_string(head.seed)}};
    return core::writeFile(markOf(folder).toStdString(), core::jsonText(mark));
}

} // namespace teleta::study
