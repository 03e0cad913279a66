// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exports/study_export.h"
#include "backend/study/session/rehearsal.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <string>

namespace teleta::study {

namespace {

constexpr char kFolder[] = TELETA_VALIDATOR_DIR;
constexpr int kInstall_ms = 900'000;
constexpr int kValidate_ms = 120'000;

constexpr char kQuestionnaires[] = R"(
[[questionnaire]]
id = "about-you"
when = "before_study"
[[questionnaire.item]]
id = "hand"
kind = "choice"
question = "Which hand do you write with?"
choice = [{ id = "left", text = "With the left" }, { id = "right" }]
[[questionnaire.item]]
id = "remarks"
kind = "text"
question = "Anything else?"
required = false
[[questionnaire]]
id = "effort"
when = "after_session"
item = [{ id = "hard", kind = "likert", question = "How hard was it?", points = 5, low = "easy", high = "hard" }]
[[questionnaire]]
id = "load"
when = "after_session"
use = "nasa-tlx-weighted"
[[questionnaire]]
id = "usability"
when = "after_study"
use = "sus"
)";

std::string program() {
    return std::string(kFolder) + "/node_modules/.bin/bids-validator";
}

/// Installs the validator once. False: it cannot be had here.
bool install() {
    if (QFile::exists(QString::fromStdString(program())))
        return true;
    const QString npm = QStandardPaths::findExecutable(QStringLiteral("npm"));
    if (npm.isEmpty() || !QDir().mkpath(QLatin1String(kFolder)))
        return false;
    for (const char* name : {"/package.json", "/package-lock.json"}) {
        const QString to = QLatin1String(kFolder) + QLatin1String(name);
        QFile::remove(to);
        if (!QFile::copy(QLatin1String(TELETA_SOURCE_DIR "/tests/peer/bids") + QLatin1String(name), to))
            return false;
    }
    QProcess process;
    process.setWorkingDirectory(QLatin1String(kFolder));
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(npm, {QStringLiteral("ci"), QStringLiteral("--ignore-scripts"),
                        QStringLiteral("--no-audit"), QStringLiteral("--no-fund")});
    return process.waitForFinished(kInstall_ms) && process.exitCode() == 0;
}

struct Verdict {
    std::set<int> errors;
    std::set<int> warnings;
    std::string text;
};

class BidsPeerTest : public testing::Test {
protected:
    void SetUp() override {
        if (!install())
            GTEST_SKIP() << "npm cannot install the validator";
    }

    /// A rehearsed study that stops after some trials.
    StudyStore rehearsed(const std::string& protocol, std::size_t participants,
                         std::size_t most = 1'000'000) {
        return rehearsed(parseProtocol(protocol, "mine.toml").value(), participants, most);
    }
    StudyStore rehearsed(const Protocol& protocol, std::size_t participants, std::size_t most = 1'000'000) {
        StudyHead head;
        head.protocol = protocol;
        head.seed = 5;
        head.mode = Mode::simulated;
        head.plannedParticipants = participants;
        head.created = QDateTime(QDate(2026, 11, 3), QTime(14, 22, 33), Qt::UTC);
        head.appVersion = "0.1.0";
        StudyStore store = std::move(StudyStore::create(m_folder.path("study"), head).value());
        RehearsalCast cast;
        cast.goOn = [most](const RehearsalProgress& now) { return now.allTrials() < most; };
        EXPECT_TRUE(rehearse(store, cast));
        return store;
    }

    [[nodiscard]] Verdict validate() const {
        QProcess process;
        process.start(QString::fromStdString(program()),
                      {QString::fromStdString(m_folder.path("study/bids")), QStringLiteral("--json")});
        EXPECT_TRUE(process.waitForFinished(kValidate_ms));
        Verdict verdict;
        verdict.text = process.readAllStandardOutput().toStdString();
        const auto answer = nlohmann::json::parse(verdict.text, nullptr, false);
        EXPECT_TRUE(answer.is_object()) << verdict.text << process.readAllStandardError().toStdString();
        if (!answer.is_object())
            return verdict;
        for (const auto& issue : answer["issues"]["errors"])
            verdict.errors.insert(issue["code"].get<int>());
        for (const auto& issue : answer["issues"]["warnings"])
            verdict.warnings.insert(issue["code"].get<int>());
        return verdict;
    }

    static std::string protocol(const std::string& more = kQuestionnaires) {
        return "author = [{ name = \"A. Writer\" }, { name = \"B. Writer\" }]\n" + smallProtocol().source +
               more;
    }

    test::TemporaryFolder m_folder;
};

} // namespace

TEST_F(BidsPeerTest, findsNothingInAStudyWithQuestionnairesAndNotes) {
    StudyStore store = rehearsed(protocol(), 3);
    const Participant first = store.participants()->front();
    ASSERT_TRUE(store.keepNote(store.sessions(first)->front(), "the \"noise\"\twas off\nfor a while",
                               QDateTime::currentDateTimeUtc()));
    ASSERT_TRUE(exportStudy(store, ExportFormat::bids));
    const Verdict verdict = validate();
    EXPECT_TRUE(verdict.errors.empty() && verdict.warnings.empty()) << verdict.text;
}

TEST_F(BidsPeerTest, findsNothingInAStudyOfOneParticipant) {
    const StudyStore store = rehearsed(protocol(), 1);
    ASSERT_TRUE(exportStudy(store, ExportFormat::bids));
    const Verdict verdict = validate();
    EXPECT_TRUE(verdict.errors.empty() && verdict.warnings.empty()) << verdict.text;
}

TEST_F(BidsPeerTest, findsNothingInAStudyWithoutQuestionnaires) {
    const StudyStore store = rehearsed(protocol(""), 2);
    ASSERT_TRUE(exportStudy(store, ExportFormat::bids));
    const Verdict verdict = validate();
    EXPECT_TRUE(verdict.errors.empty() && verdict.warnings.empty()) << verdict.text;
}

// Six tracks of one tactor each, with levels, targets and the reference in every row.
TEST_F(BidsPeerTest, findsNothingInAStudyWithTracks) {
    Protocol tracks = readProtocol(":/studies/tactor-detection.toml").value();
    tracks.authors = {"A. Writer", "B. Writer"};
    tracks =
        parseProtocol(protocolText(tracks), ":/studies/tactor-detection.toml").value(); // a store keeps text
    const StudyStore store = rehearsed(tracks, 2);
    ASSERT_TRUE(exportStudy(store, ExportFormat::bids));
    const Verdict verdict = validate();
    EXPECT_TRUE(verdict.errors.empty() && verdict.warnings.empty()) << verdict.text;
}

// A participant has 18 trials in two sessions: the second one stops within the second session.
TEST_F(BidsPeerTest, findsNothingInAnInterruptedSession) {
    StudyStore store = rehearsed(protocol(), 2, 18 + 12);
    ASSERT_TRUE(store.enrol("did not come"));
    ASSERT_TRUE(exportStudy(store, ExportFormat::bids));
    const Verdict verdict = validate();
    EXPECT_TRUE(verdict.errors.empty() && verdict.warnings.empty()) << verdict.text;
}

// What is missing is said, since it is true: 38 and 97, not all subjects have the same files and sessions.
TEST_F(BidsPeerTest, saysOnlyWhatIsMissingWhenASessionHasNotBegun) {
    const StudyStore store = rehearsed(protocol(), 2, 18 + 4);
    ASSERT_TRUE(exportStudy(store, ExportFormat::bids));
    const Verdict verdict = validate();
    EXPECT_TRUE(verdict.errors.empty()) << verdict.text;
    for (const int code : verdict.warnings)
        EXPECT_TRUE(code == 38 || code == 97) << verdict.text;
}

} // namespace teleta::study
