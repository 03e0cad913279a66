// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/files/pattern_json.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/session/rehearsal.h"
#include "backend/study/store/study_store.h"
#include "tests/backend/core/temporary_folder.h"

#include <QSqlDatabase>
#include <QSqlQuery>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace teleta::study {

namespace {

constexpr double kLength_s = 0.25;

/// A study with custom patterns: the task "taste" has no built-in ones.
class OwnStimuliTest : public testing::Test {
protected:
    /// One buzz on one tactor.
    static pattern::Pattern buzz(std::size_t tactor) {
        pattern::Pattern made;
        made.id = "buzz" + std::to_string(tactor);
        made.name = made.id;
        made.duration_s = kLength_s;
        made.tracks[tactor] = {{0.0, 0.75, pattern::Easing::linear},
                               {kLength_s, 0.75, pattern::Easing::linear}};
        return made;
    }

    [[nodiscard]] std::string protocolFile(const std::string& second = "patterns/buzz1.json") const {
        return m_folder.write("own.toml", R"(name = "own"
stimulus_s = 2.0
response_limit_s = 10.0
response_window = "from_onset"
order = "full_random"
[practice]
repetitions = 1
[test]
repetitions = 2
[masking_noise]
colour = "none"
[[task]]
id = "taste"
pattern = [
    { letter = "A", stimulus = { sweet = "patterns/buzz0.json" } },
    { letter = "B", stimulus = { sweet = ")" + second +
                                              R"(" } },
]
condition = [{ id = "sweet" }]
)");
    }

    void SetUp() override {
        std::filesystem::create_directory(m_folder.path("patterns"));
        for (const std::size_t tactor : {0, 1})
            ASSERT_TRUE(pattern::savePattern(buzz(tactor), patternFile(tactor)));
    }

    [[nodiscard]] std::string patternFile(std::size_t tactor) const {
        return m_folder.path("patterns/buzz" + std::to_string(tactor) + ".json");
    }

    [[nodiscard]] StudyHead head() const {
        StudyHead head;
        head.protocol = readProtocol(protocolFile()).value();
        head.mode = Mode::simulated;
        head.plannedParticipants = 1;
        head.created = QDateTime(QDate(2026, 11, 3), QTime(14, 22, 33), Qt::UTC);
        return head;
    }

    [[nodiscard]] std::string study() const { return m_folder.path("study"); }

    void runSql(const QString& sql) const {
        {
            QSqlDatabase database =
                QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("own"));
            database.setDatabaseName(QString::fromStdString(study() + "/study.sqlite"));
            ASSERT_TRUE(database.open());
            ASSERT_TRUE(QSqlQuery(database).exec(sql));
        }
        QSqlDatabase::removeDatabase(QStringLiteral("own"));
    }

    test::TemporaryFolder m_folder;
};

} // namespace

TEST_F(OwnStimuliTest, mayBeBuiltInOnesOfOtherLettersAndTasks) {
    const std::string path = m_folder.write("mixed.toml", test::readAll(protocolFile("stiffness.E.dynamic")));
    const Protocol protocol = readProtocol(path).value();
    EXPECT_EQ(protocol.tasks[0].patterns[1].files.at("sweet"), "stiffness.E.dynamic") << "no path";
    EXPECT_TRUE(missingStimuli(protocol).empty());
    StudyHead mixed = head();
    mixed.protocol = protocol;
    const StudyStore store = std::move(StudyStore::create(m_folder.path("study"), mixed).value());
    const pattern::Pattern* stimulus = store.head().stimuli.find("taste.B.sweet");
    ASSERT_NE(stimulus, nullptr);
    EXPECT_EQ(pattern::patternToJson(*stimulus).value(),
              pattern::patternToJson(*pattern::findBuiltIn("stiffness.E.dynamic")).value());
    ASSERT_NE(store.head().stimuli.findOwn("taste.B.sweet"), nullptr);
    EXPECT_EQ(store.head().stimuli.findOwn("taste.B.sweet")->file, "stiffness.E.dynamic");
    // It stays what it was when it is read again from the study's own text.
    EXPECT_EQ(parseProtocol(protocol.source, "again.toml")->tasks[0].patterns[1].files.at("sweet"),
              "stiffness.E.dynamic");
}

TEST_F(OwnStimuliTest, filesAreLookedForBesideTheProtocolThatNamesThem) {
    const Protocol protocol = readProtocol(protocolFile()).value();
    const std::vector<StudyPattern>& patterns = protocol.tasks[0].patterns;
    EXPECT_EQ(patterns[0].files.at("sweet"), patternFile(0));
    EXPECT_EQ(patterns[1].files.at("sweet"), patternFile(1));
    EXPECT_TRUE(missingStimuli(protocol).empty());
    const auto again = parseProtocol(protocolText(protocol), "again");
    ASSERT_TRUE(again) << core::describe(again.error());
    EXPECT_EQ(again->tasks[0].patterns[1].files, patterns[1].files);
}

TEST_F(OwnStimuliTest, aFileForAConditionThatTheTaskDoesNotHaveIsAnErrorWithItsPlace) {
    std::string text = test::readAll(protocolFile());
    text.replace(text.find("{ sweet = \"patterns/buzz1"), 7, "{ sour");
    const auto protocol = parseProtocol(text, "own.toml");
    ASSERT_FALSE(protocol);
    EXPECT_EQ(protocol.error().where.line, 16) << core::describe(protocol.error());
    EXPECT_NE(core::describe(protocol.error()).find("sour"), std::string::npos);
}

TEST_F(OwnStimuliTest, aStudyKeepsCopiesAndNeedsTheFilesNoMore) {
    std::string sha256;
    {
        const auto made = StudyStore::create(study(), head());
        ASSERT_TRUE(made) << core::describe(made.error());
        EXPECT_EQ(made->head().stimuli.sha256(), made->head().stimulusSetSha256);
        sha256 = made->head().stimulusSetSha256;
    }
    ASSERT_TRUE(pattern::savePattern(buzz(5), patternFile(0)));
    std::filesystem::remove(patternFile(1));
    const auto store = StudyStore::open(study());
    ASSERT_TRUE(store) << core::describe(store.error());
    const StimulusSet& stimuli = store->head().stimuli;
    EXPECT_TRUE(stimuli.missing().empty());
    EXPECT_EQ(stimuli.sha256(), sha256);
    for (const std::size_t tactor : {0, 1}) {
        const std::string id = tactor == 0 ? "taste.A.sweet" : "taste.B.sweet";
        ASSERT_NE(stimuli.find(id), nullptr);
        EXPECT_EQ(*stimuli.find(id), buzz(tactor));
        EXPECT_EQ(stimuli.findOwn(id)->file, "buzz" + std::to_string(tactor) + ".json");
    }
    EXPECT_EQ(stimuli.find("shape.A.static"), nullptr) << "not of this study";
    EXPECT_EQ(StimulusSet::of(paperProtocol().value(), {}, "paper")->find("shape.A.static"),
              pattern::findBuiltIn("shape.A.static"));
}

TEST_F(OwnStimuliTest, anotherPatternInTheSameFileIsAnotherStimulusSet) {
    const std::string before = StudyStore::create(study(), head())->head().stimulusSetSha256;
    ASSERT_TRUE(pattern::savePattern(buzz(5), patternFile(0)));
    EXPECT_NE(StudyStore::create(m_folder.path("other"), head())->head().stimulusSetSha256, before);
}

TEST_F(OwnStimuliTest, noStudyIsMadeOfFilesThatAreMissingOrDamaged) {
    std::filesystem::remove(patternFile(1));
    const auto missing = StudyStore::create(study(), head());
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, core::ErrorKind::notFound);
    EXPECT_EQ(missing.error().where.file, patternFile(1));
    m_folder.write("patterns/buzz1.json", "{\n  \"format\": \"teleta-pattern\",\n  oops");
    const auto damaged = StudyStore::create(study(), head());
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(damaged.error().where.file, patternFile(1));
    EXPECT_EQ(damaged.error().where.line, 3);
    StudyHead relative = head();
    relative.protocol.tasks[0].patterns[1].files["sweet"] = "buzz1.json";
    EXPECT_EQ(StudyStore::create(study(), relative).error().kind, core::ErrorKind::refused);
    EXPECT_FALSE(std::filesystem::exists(study()));
}

TEST_F(OwnStimuliTest, aCopyThatIsGoneIsNamedAndADamagedOneIsTold) {
    ASSERT_TRUE(StudyStore::create(study(), head()));
    runSql(QStringLiteral("DELETE FROM stimulus WHERE id = 'taste.B.sweet'"));
    {
        const auto store = StudyStore::open(study());
        ASSERT_TRUE(store);
        EXPECT_EQ(store->head().stimuli.missing(), std::vector<std::string>{"taste.B.sweet"});
        EXPECT_NE(store->head().stimuli.sha256(), store->head().stimulusSetSha256);
    }
    runSql(QStringLiteral("UPDATE stimulus SET pattern = '{'"));
    const auto store = StudyStore::open(study());
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().kind, core::ErrorKind::badInput);
    EXPECT_NE(store.error().where.file.find("buzz0.json"), std::string::npos);
}

TEST_F(OwnStimuliTest, noSessionGoesOnWithOtherPatternsThanTheStudyWasBegunWith) {
    ASSERT_TRUE(StudyStore::create(study(), head()));
    runSql(QStringLiteral("UPDATE study SET stimulus_set_sha256 = 'other', app_version = '0.7.1'"));
    std::optional<StudyStore> store = std::move(StudyStore::open(study()).value());
    EXPECT_EQ(store->head().stimuliChanged(), true);
    const auto refused = rehearse(*store);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, core::ErrorKind::refused);
    EXPECT_NE(core::describe(refused.error()).find("0.7.1"), std::string::npos);
    store.reset();
    // The first programs did not store it.
    runSql(QStringLiteral("UPDATE study SET stimulus_set_sha256 = ''"));
    store = std::move(StudyStore::open(study()).value());
    EXPECT_EQ(store->head().stimuliChanged(), std::nullopt);
    EXPECT_TRUE(rehearse(*store));
}

TEST_F(OwnStimuliTest, whatIsKeptOfAProtocolNamesItsFilesWholeToo) {
    const auto protocol = readProtocol(protocolFile());
    ASSERT_TRUE(protocol) << core::describe(protocol.error());
    const auto again = parseProtocol(protocol->source, "kept");
    ASSERT_TRUE(again) << core::describe(again.error());
    EXPECT_EQ(again->tasks[0].patterns[0].files, protocol->tasks[0].patterns[0].files);
    EXPECT_EQ(again->tasks[0].patterns[0].files.at("sweet"), patternFile(0));
}

TEST_F(OwnStimuliTest, aRehearsalPlaysThemAndTheExportHasThem) {
    StudyStore store = std::move(StudyStore::create(study(), head()).value());
    ASSERT_TRUE(rehearse(store));
    const Participant participant = store.participants()->front();
    const SessionRecord session = store.sessions(participant)->front();
    const std::vector<StoredTrial> trials = store.trials(session).value();
    ASSERT_EQ(trials.size(), 6U);
    for (const StoredTrial& trial : trials) {
        if (trial.result.responseTime_s.value_or(1.0) >= kLength_s) {
            EXPECT_DOUBLE_EQ(trial.result.duration_s, kLength_s);
        }
    }
    ASSERT_TRUE(exportSession(store, participant, session));
    std::string sidecar;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(study() + "/data")) {
        if (entry.path().string().ends_with("task-taste_data.json"))
            sidecar = test::readAll(entry.path().string());
    }
    const auto stimulus = nlohmann::json::parse(sidecar)["session"]["stimuli"]["A"];
    EXPECT_EQ(stimulus["file"], "buzz0.json");
    const auto written = pattern::patternFromJson(stimulus["definition"].dump(), "sidecar");
    ASSERT_TRUE(written) << core::describe(written.error());
    EXPECT_EQ(*written, buzz(0));
}

} // namespace teleta::study
