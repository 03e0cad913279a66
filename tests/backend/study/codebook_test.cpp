// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/study_results.h"
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/report/exports/codebook.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/session/rehearsal.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>

namespace teleta::study {

namespace {

/// What the codebook calls a file.
std::string kindOf(const std::filesystem::path& path) {
    const std::string name = path.filename();
    if (name.ends_with("_description-questionnaire_data.csv"))
        return "questionnaire";
    if (name.ends_with("_description-notes_data.csv"))
        return "notes";
    if (name.ends_with("_data.csv") || name.ends_with("_beh.tsv"))
        return "trials";
    if (name.ends_with("_sessions.tsv"))
        return "sessions.tsv";
    if (path.parent_path().filename() == "phenotype")
        return "phenotype";
    return name;
}

} // namespace

TEST(Codebook, hasEveryColumnOfEveryFileThatAStudyWrites) {
    const test::TemporaryFolder folder;
    StudyHead head;
    head.protocol = parseProtocol(smallProtocol().source +
                                      "[[questionnaire]]\nid = \"load\"\nwhen = \"after_session\"\n"
                                      "use = \"nasa-tlx-weighted\"\n"
                                      "[[questionnaire]]\nid = \"who\"\nwhen = \"before_study\"\n"
                                      "item = [{ id = \"age\", kind = \"text\", question = \"How old?\" }]\n",
                                  "mine.toml")
                        .value();
    head.mode = Mode::simulated;
    head.plannedParticipants = 3;
    head.created = QDateTime(QDate(2026, 11, 3), QTime(14, 22, 33), Qt::UTC);
    StudyStore store = std::move(StudyStore::create(folder.path("study"), head).value());
    ASSERT_TRUE(rehearse(store));
    ASSERT_TRUE(
        store.keepNote(store.sessions(store.participants()->front())->front(), "a note", head.created));
    ASSERT_TRUE(exportStudy(store, ExportFormat::psychds));
    ASSERT_TRUE(exportStudy(store, ExportFormat::bids));
    TrialTally tally;
    ModeFilter modes;
    ASSERT_TRUE(tallyStore(store, modes, tally));
    ASSERT_TRUE(writeResults(studyResults(tally), folder.path("study/results")));

    std::set<std::pair<std::string, std::string>> known;
    for (const CodebookEntry& entry : codebook())
        known.insert({entry.file, entry.column});
    for (const Questionnaire& questionnaire : head.protocol.questionnaires) {
        for (const CodebookEntry& entry : questionnaireEntries(questionnaire))
            known.insert({entry.file, entry.column});
    }
    std::set<std::string> kinds;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path("study"))) {
        const std::string ending = entry.path().extension();
        if (ending != ".csv" && ending != ".tsv")
            continue;
        const std::string kind = kindOf(entry.path());
        kinds.insert(kind);
        const std::string text = test::readAll(entry.path());
        std::istringstream names(text.substr(0, text.find('\n')));
        std::string column;
        while (std::getline(names, column, ending == ".csv" ? ',' : '\t'))
            EXPECT_TRUE(known.contains({kind, column})) << entry.path() << ": " << column;
    }
    for (const char* kind :
         {"trials", "questionnaire", "notes", "questionnaire_scores.csv", "codebook.csv", "participants.tsv",
          "sessions.tsv", "phenotype", "confusion_long.csv", "summary.csv", "group.csv", "anova.csv"})
        EXPECT_TRUE(kinds.contains(kind)) << kind;
}

TEST(Codebook, describesEachColumnOnce) {
    std::set<std::pair<std::string, std::string>> seen;
    for (const CodebookEntry& entry : codebook()) {
        EXPECT_TRUE(seen.insert({entry.file, entry.column}).second) << entry.file << ' ' << entry.column;
        EXPECT_FALSE(entry.description.empty()) << entry.column;
        EXPECT_FALSE(entry.description.ends_with('.')) << entry.description;
    }
    const CodebookEntry* entry = findEntry("trials", "response_time_s");
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(entry->unit, "s");
    EXPECT_EQ(findEntry("trials", "no such column"), nullptr);
    EXPECT_TRUE(codebookText().starts_with(
        "file,column,description,unit,levels,missing\ntrials,schema,Version of the columns,NA,NA,NA\n"));
}

} // namespace teleta::study
