// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/participant_report.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"

#include <QXmlStreamReader>

#include <gtest/gtest.h>

#include <vector>

namespace teleta::study {

namespace {

const QDateTime kNow(QDate(2026, 11, 3), QTime(14, 22, 33), Qt::UTC);

class ParticipantReportTest : public testing::Test {
protected:
    StudyStore create(Mode mode) {
        StudyHead head;
        head.protocol = parseProtocol(smallProtocol().source +
                                          "[[questionnaire]]\nid = \"load\"\nwhen = \"after_session\"\n"
                                          "use = \"nasa-tlx\"\n",
                                      "mine.toml")
                            .value();
        head.mode = mode;
        head.created = kNow;
        return std::move(StudyStore::create(m_folder.path("study"), head).value());
    }

    /// Test trials of a session: right, wrong, missed, and a fault that is not counted.
    static SessionRecord addSession(StudyStore& store, const std::string& id) {
        const Participant participant = store.enrol(id).value();
        const PlannedSession plan =
            planSessions(store.head().protocol, store.head().seed, participant.enrolment)[0];
        const SessionRecord session = store.beginSession(participant, 0, plan, kNow).value();
        const std::vector<std::pair<Outcome, std::optional<std::size_t>>> ends{
            {Outcome::correct, 0},
            {Outcome::correct, 0},
            {Outcome::incorrect, 2},
            {Outcome::timeout, std::nullopt},
            {Outcome::deviceError, std::nullopt}};
        std::size_t number = 0;
        for (const auto& [outcome, response] : ends) {
            TrialResult result;
            ++number;
            result.planned = {Phase::test, number, 1, 1, outcome == Outcome::correct ? 0U : 1U};
            result.trialInBlock = number;
            result.outcome = outcome;
            result.response = response;
            if (response)
                result.responseTime_s = 1.0 + static_cast<double>(number);
            EXPECT_TRUE(store.keepTrial(session, result, kNow));
        }
        return session;
    }

    test::TemporaryFolder m_folder;
};

bool has(const std::string& page, const std::string& text) {
    return page.find(text) != std::string::npos;
}

void isWellFormed(const std::string& page) {
    QXmlStreamReader reader(QString::fromStdString(page));
    while (!reader.atEnd())
        (void)reader.readNext();
    EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
}

} // namespace

TEST_F(ParticipantReportTest, tellsTheParticipantInPlainWords) {
    StudyStore store = create(Mode::run);
    const SessionRecord session = addSession(store, "P07");
    addSession(store, "P08");
    ASSERT_TRUE(store.keepNote(session, "moved the arm", kNow));
    const std::string page = participantReport(store, "P07", ReportReader::participant).value();
    isWellFormed(page);
    // Two of four completed trials; times 2 and 3 s.
    EXPECT_TRUE(has(page, "You answered 2 of 4 trials correctly: 50 %.")) << page;
    EXPECT_TRUE(has(page, "right in about 33 % of the trials"));
    EXPECT_TRUE(has(page, "within 2.5 seconds"));
    EXPECT_TRUE(has(page, "You recognised these every time: A."));
    EXPECT_TRUE(has(page, "This part was not finished."));
    EXPECT_FALSE(has(page, "class=\"mode\""));
    for (const char* others : {"P08", "moved the arm", "Wilson", "ANOVA", "NA<"})
        EXPECT_FALSE(has(page, others)) << others;
}

TEST_F(ParticipantReportTest, givesTheExperimenterEverythingOfOnePerson) {
    StudyStore store = create(Mode::run);
    const SessionRecord session = addSession(store, "P<7>");
    addSession(store, "P08");
    const Participant person = store.participants()->front();
    std::vector<ItemAnswer> answers;
    for (const QuestionnaireItem& item : store.head().protocol.questionnaires[0].items)
        answers.push_back({item.id, "35"});
    ASSERT_TRUE(store.keepAnswers(person, session, store.head().protocol.questionnaires[0], answers, kNow));
    ASSERT_TRUE(store.keepNote(session, "moved & laughed", kNow));
    const std::string page = participantReport(store, "P<7>", ReportReader::experimenter).value();
    isWellFormed(page);
    EXPECT_TRUE(has(page, "<td>2/4</td><td>50.0</td>")) << page;
    EXPECT_TRUE(has(page, "moved &amp; laughed"));
    EXPECT_TRUE(has(page, "<th scope=\"row\">tlx_raw</th><td>35.00</td>"));
    EXPECT_TRUE(has(page, "<svg"));
    EXPECT_FALSE(has(page, "P08"));
}

TEST_F(ParticipantReportTest, isNeverThatOfAPilotWithoutItsMark) {
    StudyStore store = create(Mode::pilot);
    addSession(store, "P07");
    for (const ReportReader reader : {ReportReader::participant, ReportReader::experimenter}) {
        const std::string page = participantReport(store, "P07", reader).value();
        EXPECT_TRUE(has(page, "<p class=\"mode\">PILOT"));
    }
}

TEST_F(ParticipantReportTest, refusesAStrangerAndTakesSomebodyWhoHasNotBegun) {
    StudyStore store = create(Mode::run);
    EXPECT_EQ(participantReport(store, "P99", ReportReader::participant).error().kind,
              core::ErrorKind::notFound);
    ASSERT_TRUE(store.enrol("P01"));
    const std::string page = participantReport(store, "P01", ReportReader::participant).value();
    EXPECT_TRUE(has(page, "You have not begun yet."));
    isWellFormed(participantReport(store, "P01", ReportReader::experimenter).value());
}

} // namespace teleta::study
