// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exports/participant_deletion.h"

#include "backend/core/failure.h"
#include "backend/study/report/exports/shared_files.h"
#include "backend/study/report/exports/study_export.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

namespace teleta::study {

namespace {

namespace fs = std::filesystem;

struct DeletionFilesText {
    Q_DECLARE_TR_FUNCTIONS(StudyExport)
};

bool isThere(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

/// Adds the files of a folder whose names begin with a participant's label. Labels are alphanumeric, so that
/// none is the beginning of another one before the separator.
void addLabelled(std::vector<fs::path>& files, const fs::path& folder, const std::string& label) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        if (entry.path().filename().string().starts_with(label + '_'))
            files.push_back(entry.path());
    }
}

/// Adds one participant's exported files, in every format.
void addExports(std::vector<fs::path>& files, const fs::path& folder, const std::string& label) {
    files.push_back(folder / "data" / ("subject-" + label));
    files.push_back(folder / "bids" / ("sub-" + label));
    addLabelled(files, folder / "excel", label);
}

/// What holds something about the participant at a place, and what the deletion gives other names.
std::vector<fs::path> filesToRemove(const fs::path& folder, const std::vector<Participant>& participants,
                                    std::size_t place) {
    const std::vector<std::string> labels = fileLabels(participants);
    const std::string& label = labels[place];
    // The next export writes the first three again; they have a row of each participant.
    std::vector<fs::path> files{folder / "questionnaire_scores.csv", folder / "bids" / "participants.tsv",
                                folder / "bids" / "phenotype", folder / ("report-" + label + ".html"),
                                folder / ("report-" + label + "-participant.html")};
    addExports(files, folder, label);
    addLabelled(files, folder / "recordings", label);
    std::vector<Participant> others = participants;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(place));
    const std::vector<std::string> renamed = fileLabels(others);
    for (std::size_t i = 0; i < others.size(); ++i) {
        if (const std::string& before = labels[i < place ? i : i + 1]; before != renamed[i])
            addExports(files, folder, before);
    }
    std::erase_if(files, [](const fs::path& path) { return !isThere(path); });
    return files;
}

std::vector<ExportFormat> formatsIn(const fs::path& folder) {
    std::vector<ExportFormat> formats;
    for (const auto& [name, format] : {std::pair{"data", ExportFormat::psychds},
                                       {"bids", ExportFormat::bids},
                                       {"excel", ExportFormat::excel}}) {
        if (isThere(folder / name))
            formats.push_back(format);
    }
    return formats;
}

core::Expected<std::size_t> removeAll(const std::vector<fs::path>& paths) {
    std::size_t files = 0;
    for (const fs::path& path : paths) {
        std::error_code failed;
        if (fs::is_directory(path, failed)) {
            for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path, failed))
                files += entry.is_directory() ? 0 : 1;
        } else {
            ++files;
        }
        failed.clear();
        fs::remove_all(path, failed);
        if (failed)
            return core::failed(core::ErrorKind::ioFailed,
                                DeletionFilesText::tr("cannot remove the file: %1")
                                    .arg(QString::fromStdString(failed.message())),
                                {}, {path.string()});
    }
    return files;
}

std::vector<std::string> resultsIn(const fs::path& folder) {
    std::vector<std::string> found;
    for (const fs::path& place : {folder, folder / "results"}) {
        for (const std::string& name : resultFiles()) {
            if (isThere(place / name))
                found.push_back((place / name).string());
        }
    }
    return found;
}

} // namespace

core::Expected<DeletedParticipant> deleteFromStudy(StudyStore& store, const std::string& id,
                                                   const std::string& reason, const QDateTime& now) {
    TELETA_TRY(const std::vector<Participant> participants, store.participants());
    const auto found = std::ranges::find(participants, id, &Participant::id);
    if (found == participants.end())
        return core::failed(
            core::ErrorKind::notFound,
            DeletionFilesText::tr("the study has no participant \"%1\"").arg(QString::fromStdString(id)), {},
            {store.shownName()});
    // Nobody may be about to write new files.
    TELETA_TRY(const auto runner, store.runner(*found));
    if (runner)
        return core::failed(core::ErrorKind::refused,
                            DeletionFilesText::tr("\"%1\" is in a session at %2")
                                .arg(QString::fromStdString(id), QString::fromStdString(*runner)),
                            DeletionFilesText::tr("a participant who is in no session"), {store.shownName()});
    const fs::path folder = store.folder();
    const std::vector<ExportFormat> formats =
        store.isReadOnly() ? std::vector<ExportFormat>() : formatsIn(folder);
    const std::size_t place = static_cast<std::size_t>(found - participants.begin());
    DeletedParticipant deleted;
    if (!store.isReadOnly()) {
        TELETA_TRY(deleted.files, removeAll(filesToRemove(folder, participants, place)));
    }
    TELETA_TRY(deleted.record, deleteParticipant(store, *found, reason, now));
    for (const ExportFormat format : formats)
        TELETA_CHECK(exportStudy(store, format));
    deleted.stale = resultsIn(folder);
    return deleted;
}

} // namespace teleta::study
