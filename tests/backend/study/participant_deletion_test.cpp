// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/output_file.h"
#include "backend/study/report/exports/participant_deletion.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/store/pseudonym_key.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace teleta::study {

namespace {

using test::readAll;
using test::TemporaryFolder;

const QDateTime kNow(QDate(2026, 11, 3), QTime(14, 22, 33), Qt::UTC);
/// Nobody else says this.
constexpr char kSecret[] = "xylophone";

class ParticipantDeletionTest : public testing::Test {
protected:
    [[nodiscard]] std::string folder() const { return m_folder.path("study"); }

    StudyStore create() {
        StudyHead head;
        head.protocol = smallProtocol();
        head.seed = 5;
        head.created = kNow;
        head.appVersion = "0.1.0";
        return StudyStore::create(folder(), head).value();
    }

    static void fill(StudyStore& store, const std::string& id) {
        const Participant participant = store.enrol(id).value();
        const PlannedSession plan = planSessions(store.head().protocol, 5, participant.enrolment)[0];
        const SessionRecord session = store.beginSession(participant, 0, plan, kNow).value();
        TrialResult result;
        result.planned = {Phase::test, 1, 1, 1, 0};
        result.response = 1;
        result.outcome = Outcome::incorrect;
        result.responseDevice = "keyboard";
        result.responseKey = ";";
        ASSERT_TRUE(store.keepTrial(session, result, kNow));
        ASSERT_TRUE(store.keepNote(session, std::string(kSecret) + " of " + id, kNow));
    }

    void exportAll(const StudyStore& store) const {
        for (const ExportFormat format : {ExportFormat::psychds, ExportFormat::bids, ExportFormat::excel})
            ASSERT_TRUE(exportStudy(store, format));
    }

    /// Files of the study whose name or content has the text.
    [[nodiscard]] std::vector<std::string> filesWith(const std::string& text) const {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder()))
            if (entry.path().filename().string().find(text) != std::string::npos ||
                (entry.is_regular_file() && readAll(entry.path().string()).find(text) != std::string::npos))
                found.push_back(entry.path().string());
        return found;
    }

    TemporaryFolder m_folder;
};

TEST_F(ParticipantDeletionTest, leavesNoTraceButTheRecordThatItHappened) {
    StudyStore store = create();
    for (const char* id : {"Anna", "P2", "Annabel"})
        fill(store, id);
    exportAll(store);
    ASSERT_TRUE(core::writeFile(folder() + "/report.html", "Anna was here"));
    ASSERT_TRUE(core::writeFile(folder() + "/report-Anna-participant.html", "hers"));
    ASSERT_TRUE(core::makeFolder(folder() + "/recordings"));
    for (const char* label : {"Anna", "Annabel"})
        ASSERT_TRUE(
            core::writeFile(folder() + "/recordings/" + label + "_20261103T142233.teleta", "touches"));
    const std::string before = readAll(folder() + "/excel/Annabel_20261103T142233_shape.csv");
    ASSERT_FALSE(before.empty());

    const auto deleted = deleteFromStudy(store, "Anna", "consent withdrawn", kNow.addDays(2));
    ASSERT_TRUE(deleted) << core::describe(deleted.error());
    EXPECT_EQ(deleted->record.enrolment, 0U);
    EXPECT_EQ(deleted->record.sessions, 1U);
    EXPECT_EQ(deleted->record.trials, 1U);
    EXPECT_GE(deleted->files, 8U) << "a table and notes, most with a description, in three formats";
    EXPECT_EQ(deleted->stale, std::vector<std::string>{folder() + "/report.html"});
    std::filesystem::remove(folder() + "/report.html");

    ASSERT_EQ(store.participants()->size(), 2U);
    EXPECT_EQ(readAll(folder() + "/excel/Annabel_20261103T142233_shape.csv"), before);
    const auto record = deletions(*StudyStore::open(folder()));
    ASSERT_TRUE(record);
    ASSERT_EQ(record->size(), 1U);
    EXPECT_EQ(record->front().reason, "consent withdrawn");
    EXPECT_EQ(record->front().time, kNow.addDays(2));
    EXPECT_EQ(record->front().trials, 1U);
    // Not even in the pages and the log of the database.
    EXPECT_EQ(filesWith(std::string(kSecret) + " of Anna").size(),
              filesWith(std::string(kSecret) + " of Annabel").size());
    for (const std::string& file : filesWith("Anna")) {
        std::string all = file + readAll(file);
        for (std::size_t at = all.find("Annabel"); at != std::string::npos; at = all.find("Annabel"))
            all.erase(at, 7);
        EXPECT_EQ(all.find("Anna"), std::string::npos) << file;
    }
    EXPECT_FALSE(std::filesystem::exists(folder() + "/report-Anna-participant.html"));
    EXPECT_FALSE(std::filesystem::exists(folder() + "/recordings/Anna_20261103T142233.teleta"));
    EXPECT_TRUE(std::filesystem::exists(folder() + "/recordings/Annabel_20261103T142233.teleta"));
    const std::string people = readAll(folder() + "/bids/participants.tsv");
    EXPECT_EQ(people.find("sub-Anna\t"), std::string::npos) << people;
    EXPECT_NE(people.find("sub-Annabel\t"), std::string::npos) << people;
    // What is exported again does not bring anybody back.
    exportAll(store);
    EXPECT_FALSE(std::filesystem::exists(folder() + "/data/subject-Anna"));
}

TEST_F(ParticipantDeletionTest, doesNotGiveTheNumberOfTheEnrolmentToAnybodyElse) {
    StudyStore store = create();
    fill(store, "P1");
    fill(store, "P2");
    ASSERT_TRUE(deleteFromStudy(store, "P2", "", kNow));
    EXPECT_EQ(store.enrol("P2")->enrolment, 2U);
    ASSERT_TRUE(deleteFromStudy(store, "P1", "", kNow));
    ASSERT_TRUE(deleteFromStudy(store, "P2", "", kNow));
    EXPECT_EQ(store.enrol("P3")->enrolment, 3U);
    EXPECT_EQ(deletions(store)->size(), 3U);
}

TEST_F(ParticipantDeletionTest, isRefusedForSomebodyUnknownOrInASession) {
    StudyStore store = create();
    fill(store, "P1");
    exportAll(store);
    const auto unknown = deleteFromStudy(store, "P9", "", kNow);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().kind, core::ErrorKind::notFound);
    const auto before = filesWith("P1");
    {
        StudyStore station = StudyStore::open(folder()).value();
        const auto claim = station.claim(station.participants()->front());
        ASSERT_TRUE(claim);
        const auto running = deleteFromStudy(store, "P1", "", kNow);
        ASSERT_FALSE(running);
        EXPECT_EQ(running.error().kind, core::ErrorKind::refused);
    }
    auto reading = StudyStore::openForReading(folder());
    ASSERT_TRUE(reading);
    const auto readOnly = deleteFromStudy(*reading, "P1", "", kNow);
    ASSERT_FALSE(readOnly);
    EXPECT_EQ(readOnly.error().kind, core::ErrorKind::refused);
    EXPECT_EQ(store.participants()->size(), 1U);
    EXPECT_EQ(filesWith("P1"), before);
}

TEST_F(ParticipantDeletionTest, ofALabelThatIsPartOfAnothersTakesOnlyItsOwnFiles) {
    StudyStore store = create();
    for (const char* id : {"P1", "P11", "xP1", "P1-b"})
        fill(store, id);
    exportAll(store);
    const auto filesOf = [this](const std::string& id) {
        return std::ranges::count_if(filesWith("20261103"), [&](const std::string& file) {
            return file.find("subject-" + id + "/") != std::string::npos ||
                   file.find("sub-" + id + "/") != std::string::npos ||
                   file.find("/" + id + "_") != std::string::npos;
        });
    };
    const auto others = filesOf("P11") + filesOf("xP1") + filesOf("P1bx4");
    EXPECT_GT(filesOf("P1"), 0);
    ASSERT_TRUE(deleteFromStudy(store, "P1", "", kNow));
    EXPECT_EQ(filesOf("P1"), 0);
    EXPECT_EQ(filesOf("P11") + filesOf("xP1") + filesOf("P1bx4"), others);
    EXPECT_GT(others, 0);
}

TEST(PseudonymKey, keepsPeopleApartFromTheStudyForItsOwnerAlone) {
    const TemporaryFolder folder;
    const std::string study = folder.path("study");
    const std::string path = folder.path("key.csv");
    std::filesystem::create_directory(study);
    const KeyEntry anna{"P1", "Anna, called \"A\"", "anna@example.org", kNow};
    auto key = PseudonymKey::open(path, study);
    ASSERT_TRUE(key);
    EXPECT_TRUE(key->entries().empty());
    EXPECT_FALSE(std::filesystem::exists(path)) << "reading makes no file";
    ASSERT_TRUE(key->add(anna));
    EXPECT_EQ(std::filesystem::status(path).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    // Another program, meanwhile.
    auto other = PseudonymKey::open(path, study);
    ASSERT_TRUE(other->add({"P2", "Bert", "", kNow}));
    const auto twice = key->add({"P2", "Carl", "", kNow});
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.error().kind, core::ErrorKind::refused);
    const auto read = PseudonymKey::open(path, study);
    ASSERT_EQ(read->entries().size(), 2U);
    EXPECT_EQ(read->find("P1")->name, anna.name);
    EXPECT_EQ(read->find("P1")->note, anna.note);
    EXPECT_EQ(read->find("P1")->time, kNow);
    EXPECT_EQ(read->find("P2")->note, "");
    EXPECT_FALSE(read->find("P3"));
    EXPECT_TRUE(key->remove("P1").value());
    EXPECT_FALSE(key->remove("P1").value());
    EXPECT_EQ(PseudonymKey::open(path, study)->entries().size(), 1U);
    EXPECT_EQ(folder.entries(), 2U) << "no lock is left";
}

TEST(PseudonymKey, isRefusedInTheFolderThatIsCopiedAndPublished) {
    const TemporaryFolder folder;
    const std::string study = folder.path("study");
    std::filesystem::create_directories(study + "/data");
    std::filesystem::create_directory_symlink(study, folder.path("link"));
    for (const std::string& path :
         {study + "/key.csv", study + "/data/../key.csv", folder.path("link") + "/data/key.csv"}) {
        const auto key = PseudonymKey::open(path, study + "/");
        ASSERT_FALSE(key) << path;
        EXPECT_EQ(key.error().kind, core::ErrorKind::refused);
    }
    EXPECT_TRUE(PseudonymKey::open(folder.path("study-key.csv"), study));
}

TEST(PseudonymKey, namesTheLineOfADamagedRow) {
    const TemporaryFolder folder;
    const auto damaged = PseudonymKey::open(
        folder.write("key.csv", "participant_id,name,note,time_utc\n,Anna,NA,NA\n"), folder.path("s"));
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error().where.line, 2);
    EXPECT_FALSE(PseudonymKey::open(folder.write("other.csv", "a,b\n1,2\n"), folder.path("s")));
}

TEST(Pseudonyms, areRandomAndNotTaken) {
    std::set<std::string> all;
    for (int i = 0; i < 200; ++i) {
        const std::string one = randomPseudonym({all.begin(), all.end()});
        EXPECT_EQ(one.size(), 6U);
        EXPECT_EQ(one.front(), 'P');
        EXPECT_TRUE(all.insert(one).second);
    }
}

} // namespace

} // namespace teleta::study
