// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/study_page.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/store/study_store.h"
#include "devices/simulated/simulated_bracelet.h"
#include "tests/app/console/bracelet/patient_bracelet.h"
#include "tests/app/console/study/running_session.h"
#include "widgets/study/participant/participant_window.h"
#include "widgets/study/results/page/results_view.h"
#include "widgets/study/results/result_table.h"
#include "widgets/study/session_panel.h"

#include <QCheckBox>
#include <QDir>
#include <QLineEdit>
#include <QPushButton>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace teleta::test {

inline constexpr int kPatience_ms = 20'000;

/// Two patterns, short stimuli, so that a session takes a second on a bracelet in real time.
inline constexpr char kShort[] = R"(name = "short"
stimulus_s = 0.1
response_limit_s = 10.0
response_window = "from_onset"
order = "full_random"
[practice]
repetitions = 1
feedback = true
diagram = true
[test]
repetitions = 2
[masking_noise]
colour = "pink"
level_dBA = 65.0
[[task]]
id = "shape"
name = "Object shape"
condition = [{ id = "static" }, { id = "dynamic" }]
pattern = [{ letter = "A", name = "circle" }, { letter = "B", name = "rectangle" }]
)";

/// The Study page with a real store, a simulated bracelet in real time, and an experimenter's and a
/// participant's hands.
class StudyBench {
protected:
    using Stage = study::Stage;
    using Hold = study::Hold;

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<core::StopSwitch> m_stop;
    std::unique_ptr<console::BraceletService> m_station;
    std::unique_ptr<console::StudyPage> m_page;
    std::unique_ptr<QTimer> m_tick;

    std::string m_more;      ///< of the protocol
    qint64 m_clockSet_s = 0; ///< by how much somebody has set the clock

    [[nodiscard]] QString studyFolder() const { return m_folder->filePath(QStringLiteral("study")); }

    study::StudyHead head(study::Mode mode, double stimulus_s) const {
        study::StudyHead head;
        head.protocol = *study::parseProtocol(kShort + m_more, "short.toml");
        head.protocol.stimulus_s = stimulus_s;
        head.protocol.source = study::protocolText(head.protocol);
        head.mode = mode;
        head.plannedParticipants = mode == study::Mode::simulated ? 2 : 0;
        head.created = QDateTime::currentDateTimeUtc();
        head.appVersion = "test";
        return head;
    }

    void openPage() {
        m_page = std::make_unique<console::StudyPage>(*m_station, *m_stop, core::steadyNow_ns, [this] {
            return QDateTime::currentDateTimeUtc().addSecs(m_clockSet_s);
        });
        m_page->resize(1200, 800);
        m_page->show();
        m_tick = std::make_unique<QTimer>();
        QObject::connect(m_tick.get(), &QTimer::timeout, m_page.get(), [this] {
            m_station->tick();
            m_page->tick();
        });
        m_tick->start(10);
    }
    /// A pilot study with one participant whose session can begin.
    void openStudy(study::Mode mode = study::Mode::pilot, double stimulus_s = 0.1) {
        openPage();
        controller().create(studyFolder().toStdString(), head(mode, stimulus_s));
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        if (mode == study::Mode::simulated)
            return;
        enrol("P01");
        QTRY_VERIFY_WITH_TIMEOUT(m_station->isReady(), kPatience_ms);
    }
    void enrol(const QString& id) {
        const std::size_t before = controller().overview()->participants.size();
        auto* edit = m_page->findChild<QLineEdit*>("participantId");
        QTest::keyClicks(edit, id);
        QTest::keyClick(edit, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(controller().overview()->participants.size(), before + 1, kPatience_ms);
    }
    void beginSession() {
        auto* noise = m_page->findChild<QCheckBox*>("noiseConfirmed");
        QTRY_VERIFY_WITH_TIMEOUT(noise->isVisible(), kPatience_ms);
        if (!noise->isChecked())
            QTest::mouseClick(noise, Qt::LeftButton, {}, QPoint(8, noise->height() / 2));
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        QVERIFY(window()->isVisible());
    }

    [[nodiscard]] console::StudyController& controller() { return m_page->controller(); }
    [[nodiscard]] console::StudyRunner& runner() { return controller().runner(); }
    const study::Session& session() { return sessionOf(runner()); }
    const study::PlannedTrial& current() { return trialOf(runner()); }
    [[nodiscard]] Stage stage() { return session().stage(); }
    [[nodiscard]] QPushButton* nextButton() { return m_page->findChild<QPushButton*>("nextStep"); }
    [[nodiscard]] study::SessionPanel& sessionPanel() { return *m_page->findChild<study::SessionPanel*>(); }
    [[nodiscard]] study::ResultsView& resultsView() { return *m_page->findChild<study::ResultsView*>(); }
    [[nodiscard]] study::ResultTable* resultTable(const QString& name) {
        return m_page->findChild<study::ResultTable*>(name);
    }
    [[nodiscard]] study::ParticipantWindow* window() { return &m_page->participantWindow(); }
    [[nodiscard]] simulated::SimulatedBracelet& bracelet() {
        auto& tapped = dynamic_cast<console::TappedBracelet&>(
            const_cast<core::BraceletSource&>(m_station->session()->source()));
        return dynamic_cast<simulated::SimulatedBracelet&>(tapped.bracelet());
    }
    /// The bracelet is as one whose latency was measured; NaN: nobody did.
    void setLatency(double latency_s, double spread_s = std::numeric_limits<double>::quiet_NaN()) {
        auto& described = const_cast<core::BraceletDescription&>(bracelet().description());
        described.measuredLatency_s = latency_s;
        described.latencySpread_s = spread_s;
    }
    [[nodiscard]] std::vector<study::StoredTrial> kept(std::size_t participant = 0, std::size_t session = 0) {
        const auto store = study::StudyStore::open(studyFolder().toStdString());
        if (!store)
            qFatal("%s", core::describe(store.error()).c_str());
        const auto sessions = store->sessions(store->participants()->at(participant));
        return sessions->size() > session ? *store->trials(sessions->at(session))
                                          : std::vector<study::StoredTrial>{};
    }
    [[nodiscard]] std::vector<study::StoredNote> notes() {
        const auto store = study::StudyStore::open(studyFolder().toStdString());
        return *store->notes(store->sessions(store->participants()->front())->front());
    }
    /// A statement beside the program, on the same file.
    void execute(const QString& sql) {
        {
            QSqlDatabase database = QSqlDatabase::addDatabase("QSQLITE", "beside");
            database.setDatabaseName(QDir(studyFolder()).filePath("study.sqlite"));
            QVERIFY(database.open());
            QVERIFY(QSqlQuery(database).exec(sql));
        }
        QSqlDatabase::removeDatabase("beside");
    }

    void startTrial() {
        QTRY_VERIFY_WITH_TIMEOUT(!runner().isKeeping(), kPatience_ms);
        QTest::keyClick(window(), Qt::Key_Space);
        QTRY_VERIFY2_WITH_TIMEOUT(stage() == Stage::stimulus || stage() == Stage::answering,
                                  qPrintable(runner().reason()), kPatience_ms);
    }
    void answer(std::size_t pattern) {
        QTest::keyClick(window(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(pattern)));
    }
    void doTrial() {
        startTrial();
        answer(current().stimulus);
    }
    void finishPractice() {
        doTrial();
        doTrial();
        QTest::keyClick(window(), Qt::Key_Space);
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), Hold::blockEnd, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled() && !runner().isKeeping(), kPatience_ms);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QCOMPARE(runner().hold(), Hold::none);
    }

    void setUp() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_stop = std::make_unique<core::StopSwitch>();
        m_station = test::patientBracelet(*m_stop);
        m_station->choose(console::BraceletChoice::simulated);
    }
    void tearDown() {
        m_tick.reset();
        m_page.reset();
        m_station.reset();
        m_stop.reset();
        m_more.clear();
        m_clockSet_s = 0;
    }
};

} // namespace teleta::test
