// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/plot/plot_page.h"
#include "app/console/sources/source_manager.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"
#include "backend/core/data/csv_reader.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/recorder.h"
#include "backend/recording/stream_columns.h"
#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/theme.h"
#include "widgets/signal/signal_plot.h"
#include "widgets/signal/signal_table.h"
#include "widgets/signal/signals_mime.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDateTime>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>
#include <numbers>

using namespace teleta;
using console::PlotPage;
using console::SourceManager;

namespace {

constexpr std::int64_t kStart_ns = 50'000'000'000;
constexpr int kFrames = 2000;

/// An arm with links of a file, for a moment.
void recordSevenJoints(const QString& path) {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/resources/arms/seven-joints.urdf").value();
    const auto chain = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(model),
                                                      "base_link", "tool0")
                           .value();
    core::ArmDescription description;
    description.name = "robot";
    description.nominalRate_Hz = 100.0;
    description.lowest_rad = chain.lowest();
    description.highest_rad = chain.highest();
    description.fastest_radPerS = chain.fastest();
    recording::RecordingHead head;
    head.start_ns = kStart_ns;
    auto recorder = recording::Recorder::start(path.toStdString(), head, {.simulatedTime = true}).value();
    const auto tap = recorder->addStream(pipeline::armStream("robot/joints", description, {}, &chain));
    tap->append(kStart_ns, 0.0, std::span<const double>(std::vector<double>(21, 0.5)));
    QVERIFY(recorder->stop());
}

/// One joint whose angle is a sine of 0.3 rad at 10 Hz, 2 s at 1 kHz.
void recordSine(const QString& path, const std::string& details = {}) {
    recording::RecordingHead head;
    head.start_ns = kStart_ns;
    auto recorder = recording::Recorder::start(path.toStdString(), head, {.simulatedTime = true}).value();
    recording::StreamInfo joints = recording::jointStream(1000.0, 1);
    joints.details = details;
    const auto tap = recorder->addStream(std::move(joints));
    for (int i = 0; i < kFrames; ++i) {
        const std::vector<double> values{0.3 * std::sin(2.0 * std::numbers::pi * 0.01 * i), 0.0, 0.0};
        tap->append(kStart_ns + 1'000'000LL * i, 0.001 * i, std::span<const double>(values));
    }
    QVERIFY(recorder->stop());
}

} // namespace

class PlotPageTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    core::StopSwitch m_stop;
    std::unique_ptr<console::ConsoleSettings> m_settings;
    std::unique_ptr<SourceManager> m_sources;
    std::unique_ptr<PlotPage> m_page;
    const signal::SignalId m_angle{"sine.teleta", "joints", "q1"};

    void tick() {
        m_sources->poll();
        m_page->tick();
        QCoreApplication::processEvents();
    }
    [[nodiscard]] bool ticks(const std::function<bool()>& until) {
        return QTest::qWaitFor([&] {
            tick();
            return until();
        });
    }
    [[nodiscard]] base::ProvenanceBadge& badge() const {
        return *m_page->findChild<base::ProvenanceBadge*>("plotProvenance");
    }
    void openRecording(const QString& name = QStringLiteral("sine.teleta")) {
        m_page->plotSignals().sources().addRecording(m_folder.filePath(name));
        QVERIFY(ticks([this] { return !m_page->plotSignals().sources().entries().empty(); }));
    }
    void plotAngle() {
        openRecording();
        m_page->plotSignals().add({m_angle});
        QVERIFY(ticks([this] { return m_page->plotSignals().shown().front().raw != nullptr; }));
    }

private slots:
    void aSmallNewestValueHasItsDigitsToo() {
        QCOMPARE(PlotPage::newestText(0.00123456), QStringLiteral("0.00123"));
        QCOMPARE(PlotPage::newestText(-0.0456), QStringLiteral("\u22120.0456"));
        QCOMPARE(PlotPage::newestText(0.0), QStringLiteral("0"));
        QCOMPARE(PlotPage::newestText(7.7077).trimmed(), QStringLiteral("7.71"));
        QCOMPARE(PlotPage::newestText(13283.4).trimmed(), QStringLiteral("13283"));
    }

    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        base::applyTheme(base::ThemeChoice::light);
        recordSine(m_folder.filePath("sine.teleta"));
        recordSine(m_folder.filePath("simulated.teleta"), R"({"simulated": true})");
        recordSevenJoints(m_folder.filePath("robot.teleta"));
    }
    void init() {
        m_settings = std::make_unique<console::ConsoleSettings>(false);
        for (const QString& name : m_settings->plotLayouts().keys())
            m_settings->setPlotLayout(name, {});
        m_sources = std::make_unique<SourceManager>(m_stop);
        m_page = std::make_unique<PlotPage>(*m_sources, *m_settings);
        m_page->resize(1000, 700);
        m_page->show();
        QVERIFY(QTest::qWaitForWindowActive(m_page.get()));
    }
    void cleanup() {
        m_page.reset();
        m_sources.reset();
    }

    void anEmptyPageSaysWhatToDo() {
        auto* demo = m_page->findChild<QPushButton*>("plotDemo");
        QVERIFY(demo != nullptr && demo->isVisible());
        QSignalSpy asked(m_page.get(), &PlotPage::demoRequested);
        QTest::mouseClick(demo, Qt::LeftButton);
        QCOMPARE(asked.count(), 1);
    }

    void aKeyLeadsToTheSearch() {
        openRecording();
        m_page->tree().view().setFocus();
        QTest::keyClick(&m_page->tree().view(), Qt::Key_F, Qt::ControlModifier);
        QVERIFY(m_page->tree().search().hasFocus());
        QTest::keyClicks(&m_page->tree().search(), "q1");
        QCOMPARE(m_page->tree().search().text(), QStringLiteral("q1"));
    }

    void theJointsOfARunningArmHaveTheirNames() {
        m_sources->open(app::SceneRequest{":/scenes/teleta-touch.toml", 1});
        const auto joints = [this]() -> std::optional<signal::SourceEntry::Stream> {
            for (const signal::SourceEntry& entry : m_page->plotSignals().sources().entries())
                for (const auto& stream : entry.streams)
                    if (!stream.columns.empty() && stream.columns.front().name == "q1")
                        return stream;
            return std::nullopt;
        };
        QVERIFY(ticks([&] { return joints().has_value(); }));
        QCOMPARE(joints()->meanings.size(), std::size_t(12)); // angle, torque and reference of each
        QCOMPARE(joints()->meanings[0], QStringLiteral("shoulder roll"));
        QCOMPARE(joints()->columns[7].name, std::string("tau4"));
        QCOMPARE(joints()->meanings[7], QStringLiteral("elbow pitch"));
    }

    void theJointsOfARecordedArmHaveTheNamesOfItsLinks() {
        openRecording("robot.teleta");
        const auto stream = m_page->plotSignals().sources().entries().front().streams.front();
        const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/resources/arms/seven-joints.urdf").value();
        QCOMPARE(stream.meanings.size(), std::size_t{21});
        const QString second = stream.meanings[1];
        QVERIFY(std::ranges::any_of(
            model.joints, [&](const auto& joint) { return QString::fromStdString(joint.name) == second; }));
        m_page->plotSignals().add({{"robot.teleta", stream.name, "q2"}});
        QVERIFY(ticks([this] { return m_page->plotSignals().shown().front().raw != nullptr; }));
        QCOMPARE(m_page->table().view().topLevelItem(0)->text(0),
                 QStringLiteral("q2 of %1, robot.teleta").arg(second));
    }

    void clockTimesAreThoseOfTheRecording() {
        plotAngle();
        const double start_unix_s = m_page->plotSignals().sources().find(m_angle)->start_unix_s;
        QVERIFY2(std::abs(start_unix_s - static_cast<double>(QDateTime::currentSecsSinceEpoch())) < 3600.0,
                 "it was recorded just now");
        QTRY_VERIFY(std::abs(m_page->plot().from_s()) < 1e-6);
        auto* time = m_page->findChild<QComboBox*>("plotTime");
        time->setFocus();
        QTest::keyClick(time, Qt::Key_Down);
        QCOMPARE(m_page->plot().from_s(), start_unix_s);
        m_page->plot().moveCursor(0, start_unix_s + 0.025);
        QTreeWidget& table = m_page->table().view();
        QVERIFY(ticks([&] { return table.topLevelItem(0)->text(1).trimmed().startsWith("0.3"); }));
        m_page->plot().setRange(start_unix_s + 0.1, start_unix_s + 0.1095);
        const QString path = m_folder.filePath("clock.csv");
        m_page->saveData(path);
        QVERIFY(ticks([this] { return m_page->messages().count() == 1; }));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = file.readAll().split('\n');
        QCOMPARE(lines.first(), QByteArray("utc_s,q1_rad"));
        QVERIFY(std::abs(lines[1].split(',').front().toDouble() - start_unix_s - 0.1) < 0.0015);
        m_page->layouts().save("clock");
        QTest::keyClick(time, Qt::Key_Up);
        QTRY_VERIFY(std::abs(m_page->plot().from_s()) < 1e-6);
        m_page->layouts().choose("clock");
        QCOMPARE(time->currentIndex(), 1);
    }

    void whatIsOutsideTheViewIsSaid() {
        plotAngle();
        const auto* state = m_page->findChild<QLabel*>("plotState");
        QVERIFY(ticks([&] { return state->text().isEmpty(); }));
        m_page->plot().setRange(100.0, 110.0);
        QVERIFY(ticks([&] { return state->text().contains("outside the view"); }));
        QTest::keyClick(&m_page->plot(), Qt::Key_Home);
        QVERIFY(ticks([&] { return state->text().isEmpty(); }));
    }

    void eachKindOfDataHasItsBadge() {
        plotAngle();
        m_sources->open(app::SceneRequest{":/scenes/tactile-indenter.toml", 1});
        const auto live = [this] {
            for (const signal::SourceEntry& entry : m_page->plotSignals().sources().entries())
                if (entry.note.isEmpty() && !entry.streams.empty())
                    return entry.name;
            return std::string();
        };
        QVERIFY(ticks([&] { return !live().empty(); }));
        m_page->plotSignals().add({{live(), "features", "force_n"}});
        QCOMPARE(badge().provenance(), base::Provenance::simulated);
        auto* second = m_page->findChild<base::ProvenanceBadge*>("plotProvenance1");
        QVERIFY(second->isVisible());
        QCOMPARE(second->provenance(), base::Provenance::recorded);
        m_page->plotSignals().remove({1});
        QCOMPARE(badge().provenance(), base::Provenance::recorded);
        QVERIFY(!second->isVisible());
    }

    void aDroppedSignalOfARunningSceneIsDrawn() {
        m_sources->open(app::SceneRequest{":/scenes/tactile-indenter.toml", 1});
        QVERIFY(ticks([this] {
            return !m_page->plotSignals().sources().entries().empty() &&
                   !m_page->plotSignals().sources().entries().front().streams.empty();
        }));
        const auto entry = m_page->plotSignals().sources().entries().front();
        std::vector<std::string> streams;
        for (const auto& stream : entry.streams)
            streams.push_back(stream.name);
        QVERIFY(std::ranges::find(streams, "features") != streams.end());
        const auto mime = signal::mimeOf({{entry.name, "features", "force_n"}});
        auto* area = m_page->findChild<QWidget*>("dropArea");
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, mime.get(), Qt::LeftButton, {});
        QApplication::sendEvent(area, &enter);
        QDropEvent drop(QPointF(50, 50), Qt::CopyAction, mime.get(), Qt::LeftButton, {});
        QApplication::sendEvent(area, &drop);
        QCOMPARE(m_page->plotSignals().shown().size(), std::size_t{1});
        QVERIFY(m_page->plot().isVisible());
        QVERIFY(m_page->plot().isFollowing());
        QVERIFY(ticks([this] {
            const auto raw = m_page->plotSignals().shown().front().raw;
            return !raw->empty() && m_page->plot().to_s() > raw->time_s(0);
        }));
        QVERIFY(ticks([this] { return m_page->plotSignals().shown().front().raw->size() > 50; }));
        const auto series = m_page->plotSignals().shown().front().raw;
        const auto size = series->size();
        QVERIFY2(ticks([&] { return series->size() > size + 20; }), "it goes on");
        m_sources->closeAll();
        QVERIFY(ticks([this] { return m_page->plotSignals().sources().entries().empty(); }));
        QVERIFY2(m_page->plotSignals().shown().front().raw != nullptr, "what was drawn stays");
        QVERIFY2(badge().isVisible(), "and is still no measurement");
        QCOMPARE(badge().provenance(), base::Provenance::simulated);
    }

    void dataThatAreNotLiveSaySo() {
        QVERIFY(!badge().isVisible());
        plotAngle();
        QVERIFY(badge().isVisible());
        QCOMPARE(badge().provenance(), base::Provenance::recorded);
        m_page->plotSignals().sources().addRecording(m_folder.filePath("simulated.teleta"));
        QVERIFY(ticks([this] { return m_page->plotSignals().sources().entries().size() == 2; }));
        m_page->plotSignals().add({{"simulated.teleta", "joints", "q1"}});
        QVERIFY(ticks([this] { return m_page->plotSignals().shown()[1].raw != nullptr; }));
        QCOMPARE(badge().provenance(), base::Provenance::recordedSimulation);
        QTreeWidget& table = m_page->table().view();
        table.setFocus();
        table.setCurrentItem(table.topLevelItem(1));
        QTest::keyClick(&table, Qt::Key_Delete);
        QCOMPARE(badge().provenance(), base::Provenance::recorded);
        table.setCurrentItem(table.topLevelItem(0));
        QTest::keyClick(&table, Qt::Key_Delete);
        QVERIFY(!badge().isVisible());
    }

    void aReadingIsCancelledAndDoneAgain() {
        openRecording();
        auto* cancel = m_page->findChild<QToolButton*>("cancelReading");
        auto* progress = m_page->findChild<QProgressBar*>();
        QVERIFY(!cancel->isVisible());
        m_page->plotSignals().add({m_angle}); // its result is taken by the event loop, not before
        QVERIFY(cancel->isVisible() && progress->isVisible());
        QTest::mouseClick(cancel, Qt::LeftButton);
        QVERIFY(m_page->plotSignals().shown().empty());
        QVERIFY(!cancel->isVisible() && !progress->isVisible());
        QTest::keyClick(m_page.get(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_page->plotSignals().shown().size(), std::size_t{1});
        QVERIFY(ticks([this] { return m_page->plotSignals().shown().front().raw != nullptr; }));
        QCOMPARE(m_page->plotSignals().shown().front().raw->size(), std::size_t{kFrames});
        QVERIFY(!cancel->isVisible());
        QCOMPARE(m_page->messages().count(), 0);
    }

    void aRecordingIsReadAsAWhole() {
        plotAngle();
        const auto& shown = m_page->plotSignals().shown().front();
        QCOMPARE(shown.raw->size(), std::size_t{kFrames});
        QCOMPARE(shown.note, QString());
        QVERIFY(ticks([this] { return m_page->plot().to_s() > 1.9; }));
        QVERIFY(std::abs(m_page->plot().from_s()) < 1e-6);
        QCOMPARE(m_page->plot().isFollowing(), false);
        QCOMPARE(m_page->table().view().topLevelItem(0)->text(4), QString("rad"));
    }

    void aSignalWhoseSourceIsNotOpenWaitsForIt() {
        m_page->plotSignals().add({m_angle});
        QVERIFY(!m_page->plotSignals().shown().front().note.isEmpty());
        openRecording();
        QVERIFY(ticks([this] { return m_page->plotSignals().shown().front().raw != nullptr; }));
        QVERIFY(m_page->plotSignals().shown().front().note.isEmpty());
    }

    void aSignalNamedAtTheStartIsPlottedOnceItsSourceIsThere() {
        m_page->plotNamed({QStringLiteral("sine.teleta/joints/q1"), QStringLiteral("a/b/c/d")});
        const auto plotted = m_page->plotSignals().plotted();
        QCOMPARE(plotted.size(), std::size_t{2});
        QVERIFY(plotted[0].id == m_angle);
        QVERIFY((plotted[1].id == signal::SignalId{"a", "b/c", "d"}));
        openRecording();
        QVERIFY(ticks([this] { return m_page->plotSignals().shown().front().raw != nullptr; }));
    }

    void derivativeAndSpectrumAreThoseOfTheSine() {
        plotAngle();
        QTreeWidget& table = m_page->table().view();
        table.setFocus();
        table.setCurrentItem(table.topLevelItem(0));
        QTest::keyClick(&table, Qt::Key_D);
        QCOMPARE(table.topLevelItemCount(), 2);
        QVERIFY(table.topLevelItem(1)->text(0).contains("d/dt"));
        QCOMPARE(table.topLevelItem(1)->text(4), QString("rad/s"));
        QVERIFY(ticks([this] {
            const auto slope = m_page->plotSignals().shown()[1].series();
            return slope->size() == kFrames - 2;
        }));
        const double speed = 0.3 * 2.0 * std::numbers::pi * 10.0;
        const auto range = m_page->plotSignals().shown()[1].series()->range(0, kFrames);
        QVERIFY(std::abs(range->high - speed) < 0.01 * speed);

        QTest::keyClick(&table, Qt::Key_S);
        QVERIFY(ticks([this] { return m_page->plotSignals().shown()[0].spectrum != nullptr; }));
        const signal::Spectrum& spectrum = *m_page->plotSignals().shown()[0].spectrum;
        const auto peak = std::ranges::max_element(spectrum.amplitude);
        QVERIFY(std::abs(spectrum.frequency_Hz[static_cast<std::size_t>(peak - spectrum.amplitude.begin())] -
                         10.0) < 4.0);
        QVERIFY(m_page->findChild<QCheckBox*>("density")->isVisible());

        // The same by buttons, for those who do not know the keys.
        for (QAction* action : m_page->table().rowActions()) {
            const auto buttons = m_page->table().findChildren<QToolButton*>();
            const auto button = std::ranges::find(buttons, action, &QToolButton::defaultAction);
            QVERIFY2(button != buttons.end() && (*button)->isVisible(), qPrintable(action->text()));
            const QSignalSpy done(action, &QAction::triggered);
            QTest::mouseClick(*button, Qt::LeftButton);
            QCOMPARE(done.count(), 1);
        }
        QCOMPARE(table.topLevelItemCount(), 1); // its derivative was there; the chosen one is removed
    }

    void tooFewSamplesInViewAreNoSpectrum() {
        plotAngle();
        m_page->plot().setRange(0.5, 0.52);
        m_page->plotSignals().setSpectrum(0, true);
        QVERIFY(ticks([this] { return !m_page->plotSignals().shown().front().spectrumNote.isEmpty(); }));
        QVERIFY(m_page->table().view().topLevelItem(0)->text(0).contains("64"));
    }

    void cursorsShowDifferences() {
        plotAngle();
        m_page->plot().moveCursor(0, 0.0);
        m_page->plot().moveCursor(1, 0.025);
        QTreeWidget& table = m_page->table().view();
        QVERIFY(ticks([&] { return table.topLevelItem(0)->text(3).startsWith("0.3"); }));
        QVERIFY(m_page->table().times().contains("25"));
        QVERIFY(m_page->findChild<QCheckBox*>("cursors")->isChecked());
    }

    void deleteRemovesAndUndoBringsBack() {
        plotAngle();
        QTreeWidget& table = m_page->table().view();
        table.setFocus();
        table.setCurrentItem(table.topLevelItem(0));
        QTest::keyClick(&table, Qt::Key_Delete);
        QVERIFY(m_page->plotSignals().shown().empty());
        QVERIFY(m_page->findChild<QPushButton*>("plotDemo")->isVisible());
        QTest::keyClick(m_page.get(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_page->plotSignals().shown().size(), std::size_t{1});
        QVERIFY(m_page->plotSignals().shown().front().raw != nullptr);
    }

    void aReadingThatIsCancelledLateKeepsWhatWasRemoved() {
        plotAngle();
        m_page->plotSignals().remove({0});
        m_page->plotSignals().cancelReading();
        QVERIFY(m_page->plotSignals().canUndo());
    }

    void whatIsInViewIsSavedWithUnits() {
        plotAngle();
        m_page->plot().setRange(0.1, 0.1095);
        const QString path = m_folder.filePath("view.csv");
        m_page->saveData(path);
        QVERIFY(ticks([&] { return QFile::exists(path); }));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = file.readAll().split('\n');
        QCOMPARE(lines.first(), QByteArray("time_s,q1_rad"));
        QCOMPARE(lines.size(), 1 + 10 + 1);
        QVERIFY(ticks([this] { return m_page->messages().count() == 1; }));
    }

    void layoutsAreKeptUnderANameAndRestored() {
        plotAngle();
        m_page->plotSignals().addDerivative(0);
        m_page->plotSignals().setSpectrum(0, true);
        m_page->plot().setRange(0.5, 1.5);
        m_page->layouts().save("  angle ");
        QCOMPARE(m_settings->plotLayouts().keys(), QStringList{"angle"});
        m_page->plotSignals().remove({0, 1});
        m_page->plot().setRange(0.0, 30.0);
        m_page->layouts().choose("angle");
        const auto& shown = m_page->plotSignals().shown();
        QCOMPARE(shown.size(), std::size_t{2});
        QVERIFY(shown[0].what.spectrum && shown[1].what.derivative);
        QCOMPARE(m_page->plot().span_s(), 1.0);
        m_settings->setPlotLayout("newer", R"({"version": 99})");
        m_page->layouts().choose("newer");
        QCOMPARE(m_page->messages().count(), 1);
        QCOMPARE(m_page->plotSignals().shown().size(), std::size_t{2});
    }

    void aFileThatIsNoRecordingIsReported() {
        QFile file(m_folder.filePath("broken.teleta"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("no database");
        file.close();
        m_page->plotSignals().sources().addRecording(file.fileName());
        QVERIFY(ticks([this] { return m_page->messages().count() == 1; }));
        QVERIFY(m_page->plotSignals().sources().entries().empty());
    }
};

QTEST_MAIN(PlotPageTest)
#include "plot_page_test.moc"
