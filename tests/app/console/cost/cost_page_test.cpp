// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/cost/cost_page.h"
#include "app/console/sources/source_manager.h"
#include "backend/cost/cost_file.h"
#include "widgets/base/background.h"
#include "widgets/base/theme.h"
#include "widgets/cost/cost_chart.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFontMetrics>
#include <QLabel>
#include <QLayout>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <QTimer>

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <optional>

using namespace teleta;
using console::CostPage;
using console::SourceManager;

namespace {

/// Rungs whose errors are 3, 2, 1 mm; they wait while `held` is set.
cost::Ladder quickLadder(const std::string& name, std::shared_ptr<std::atomic<bool>> held = nullptr) {
    cost::Ladder ladder;
    ladder.name = name;
    ladder.title = "Title of " + name;
    ladder.truth = "distance";
    ladder.errorUnit = std::string("m");
    ladder.makeRungs = [held]() -> core::Expected<std::vector<cost::Rung>> {
        std::vector<cost::Rung> rungs;
        for (const int number : {3, 2, 1})
            rungs.push_back({"rung-" + std::to_string(number), "parameter", [=](cost::Trial& trial) {
                                 volatile double x = 0.0;
                                 trial.timed(1, [&] {
                                     for (int i = 0; i < 2000; ++i)
                                         x = x + 1.0;
                                 });
                                 trial.error(0.001 * number);
                                 while (held && *held)
                                     QThread::yieldCurrentThread();
                             }});
        return rungs;
    };
    return ladder;
}

cost::MeasureSettings patient() {
    cost::MeasureSettings settings;
    settings.largestSpread = std::numeric_limits<double>::infinity();
    return settings;
}

/// Two rungs of the camera: the exact one takes 20 ms, the other 2 ms.
std::vector<cost::LadderCost> knownCosts() {
    cost::RungCost dots{.name = "dots",
                        .parameter = "dots only",
                        .errorMean = 0.0004,
                        .errorP95 = 0.001,
                        .errorMax = 0.002,
                        .timeMedian_s = 0.018,
                        .timeP99_s = 0.020,
                        .samples = 30,
                        .pareto = true};
    cost::RungCost flow{.name = "ultrafast-3.2",
                        .parameter = "scale 1/3.2",
                        .errorMean = 0.02,
                        .errorP95 = 0.05,
                        .errorMax = 0.06,
                        .timeMedian_s = 0.001,
                        .timeP99_s = 0.002,
                        .samples = 30,
                        .pareto = true};
    return {{"contact-flow", "m", {dots, flow}}};
}

/// A small tube, so that frames are drawn quickly.
constexpr char kTubeScene[] = R"(
name = "tube"
description = "A small tube that nothing touches."
duration_s = 60.0
rate_Hz = 40.0
[camera]
width_px = 410
height_px = 308
focal_length_px = 147.0
behind_m = 0.020
[skin]
radius_m = 0.025
length_m = 0.060
dot_pitch_m = 0.005
dot_diameter_m = 0.002
reach_m = 0.0015
[[finger]]
name = "tool"
radius_m = 0.008
keyframes = [ { time_s = 0.0, angle_rad = 0.8, z_m = 0.020, depth_m = -0.010 } ]
[[effects]]
name = "lens_distortion"
why = "A lens of 160 degrees is no pinhole."
k1 = 0.77777778
k2 = 0.06772487
k4 = 1.11111111
k5 = 0.23809524
)";

constexpr int kPatience_ms = 60'000;

} // namespace

/// The page with ladders that are quickly measured, and with a simulated camera.
class CostPageTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QTimer m_clock;
    core::StopSwitch m_stop;
    std::unique_ptr<SourceManager> m_sources;
    std::unique_ptr<CostPage> m_page;

    [[nodiscard]] QString file() const { return m_folder.filePath(QStringLiteral("cost/tradeoff.csv")); }
    template <typename Widget>
    [[nodiscard]] Widget& part(const char* name) {
        return *m_page->findChild<Widget*>(QLatin1String(name));
    }
    void open(const std::vector<cost::Ladder>& ladders) {
        openWith([ladders] { return ladders; });
    }
    void openWith(console::CostMeasuring::MakeLadders makeLadders) {
        m_page = std::make_unique<CostPage>(std::move(makeLadders), file(), patient());
        m_page->resize(1400, 800);
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
        connect(&m_clock, &QTimer::timeout, m_page.get(), [this] {
            std::shared_ptr<pipeline::CameraChannel> camera;
            if (m_sources) {
                m_sources->poll();
                if (const SourceManager::Item* item = m_sources->active())
                    camera = item->camera();
                if (camera)
                    camera->update();
            }
            m_page->tick(camera);
        });
        m_clock.start(10);
    }
    void openCamera() {
        QFile scene(m_folder.filePath(QStringLiteral("tube.toml")));
        QVERIFY(scene.open(QIODevice::WriteOnly));
        scene.write(kTubeScene);
        scene.close();
        m_sources = std::make_unique<SourceManager>(m_stop);
        QSignalSpy failed(m_sources.get(), &SourceManager::failed);
        m_sources->open(app::SceneRequest{scene.fileName().toStdString(), 1});
        QTRY_VERIFY_WITH_TIMEOUT(part<QComboBox>("rung").isVisible() || !failed.isEmpty(), kPatience_ms);
        QVERIFY(failed.isEmpty());
    }
    [[nodiscard]] QString rungOfCamera() {
        const SourceManager::Item* item = m_sources->active();
        const auto rung = item->camera()->snapshot().rung;
        return QString::fromUtf8(rung.data(), static_cast<qsizetype>(rung.size()));
    }

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }
    void cleanup() {
        m_clock.stop();
        m_page.reset();
        m_sources.reset();
        QFile::remove(file());
    }

    void aJobIsReadToItsEndInAListOfAnyWidth() {
        cost::Ladder ladder = quickLadder("second");
        ladder.title = "Gains of an array's taxels from a press";
        open({quickLadder("first"), ladder});
        auto& list = part<QListWidget>("ladders");
        QListWidgetItem* item = list.item(1);
        const auto picture = [&](const QString& last) {
            item->setText(QString::fromStdString(ladder.title) + QLatin1Char('\n') + last);
            QCoreApplication::processEvents();
            return list.viewport()->grab().toImage();
        };
        for (int width = 180; width <= 300; ++width) {
            list.setFixedWidth(width);
            // Its last line is seen.
            QVERIFY2(picture(QStringLiteral("abc")) != picture(QStringLiteral("cba")),
                     qPrintable(QString::number(width)));
        }
    }

    void jobsOfOneTopicStandBelowItsHeadingAndTheKeysPassItOver() {
        const auto of = [](std::optional<cost::Topic> topic, const char* name) {
            cost::Ladder ladder = quickLadder(name);
            ladder.topic = topic;
            return ladder;
        };
        open({of(cost::Topic::camera, "contact-flow"), of(cost::Topic::touchedObject, "stiffness"),
              of(cost::Topic::camera, "undistortion"), of(std::nullopt, "of-another-program")});
        auto& list = part<QListWidget>("ladders");
        QStringList rows;
        for (int row = 0; row < list.count(); ++row)
            rows << (list.item(row)->flags().testFlag(Qt::ItemIsEnabled)
                         ? list.item(row)->data(Qt::UserRole).toString()
                         : list.item(row)->text());
        QCOMPARE(rows, (QStringList{"Camera", "contact-flow", "undistortion", "Touched object", "stiffness",
                                    "of-another-program"}));
        QCOMPARE(list.currentRow(), 1);
        list.setFocus();
        for (const int row : {2, 4, 5}) {
            QTest::keyClick(&list, Qt::Key_Down);
            QCOMPARE(list.currentRow(), row);
        }
    }

    void measuresTheLadderThatIsShownAndKeepsItForTheNextStart() {
        open({quickLadder("first"), quickLadder("second")});
        const auto job = [this](int row) { return part<QListWidget>("ladders").item(row); };
        const auto isMeasured = [&](int row) { return job(row)->text().contains(QLatin1Char('\n')); };
        QVERIFY(!isMeasured(0));
        QVERIFY(job(0)->toolTip().contains(QLatin1String("not measured")));
        QVERIFY(!part<QTableWidget>("rungs").isVisible());
        QVERIFY2(!part<QPushButton>("measure").isVisible(), "one button measures");
        QTest::mouseClick(&part<QPushButton>("measureEmpty"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(part<QTableWidget>("rungs").rowCount(), 3, kPatience_ms);
        QVERIFY(part<QTableWidget>("rungs").isVisible());
        QVERIFY(part<QPushButton>("measure").isVisible());
        QVERIFY(isMeasured(0));
        QVERIFY(!isMeasured(1));
        QVERIFY(part<QTableWidget>("rungs").item(2, 2)->text().contains(QStringLiteral("1.00")));
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file()), kPatience_ms);

        m_page.reset();
        open({quickLadder("first"), quickLadder("second")});
        QTRY_COMPARE_WITH_TIMEOUT(part<QTableWidget>("rungs").rowCount(), 3, kPatience_ms);
    }

    void showsProgressAndIsCancelledInMidRungWithoutLosingWhatThereWas() {
        const auto held = std::make_shared<std::atomic<bool>>(true);
        open({quickLadder("first", held), quickLadder("second")});
        QVERIFY(!part<QPushButton>("cancel").isEnabled());
        QTest::mouseClick(&part<QPushButton>("measureAll"), Qt::LeftButton);
        QTRY_VERIFY(part<QPushButton>("cancel").isEnabled());
        QVERIFY(!part<QPushButton>("measureEmpty").isEnabled());
        const auto says = [this](const QString& text) {
            return std::ranges::any_of(m_page->findChildren<QLabel*>(), [&](const QLabel* label) {
                return label->isVisible() && label->text() == text;
            });
        };
        QVERIFY(says("Measuring"));
        QVERIFY(!says("Not measured on this machine"));
        QTest::mouseClick(&part<QPushButton>("cancel"), Qt::LeftButton);
        // It is seen at once that the click was taken.
        QVERIFY(says(QStringLiteral("Stopping\u2026")));
        QVERIFY(!part<QPushButton>("cancel").isEnabled());
        const QRect cancel(part<QPushButton>("cancel").mapTo(m_page.get(), QPoint()),
                           part<QPushButton>("cancel").size());
        *held = false;
        QTRY_VERIFY_WITH_TIMEOUT(!m_page->measuring().isRunning(), kPatience_ms);
        QVERIFY(!part<QPushButton>("cancel").isEnabled());
        QVERIFY(part<QPushButton>("measureEmpty").isEnabled());
        QVERIFY(m_page->measuring().costOf("second") == nullptr);
        // A late click on Cancel begins nothing.
        QVERIFY(says("Not measured on this machine"));
        m_page->layout()->activate();
        QCoreApplication::processEvents();
        for (const char* name : {"measureEmpty", "measureAll"}) {
            const auto& button = part<QPushButton>(name);
            QVERIFY(!cancel.intersects(QRect(button.mapTo(m_page.get(), QPoint()), button.size())));
        }
        QTest::mouseClick(m_page.get(), Qt::LeftButton, {}, cancel.center());
        QVERIFY(!m_page->measuring().isRunning());
    }

    void aPageThatIsClosedWhileItMeasuresIsNotWaitedFor() {
        const auto held = std::make_shared<std::atomic<bool>>(true);
        open({quickLadder("first", held)});
        QTest::mouseClick(&part<QPushButton>("measureEmpty"), Qt::LeftButton);
        QTRY_VERIFY(m_page->measuring().isRunning());
        m_page.reset();
        *held = false;
        QVERIFY(base::backgroundPool().waitForDone(kPatience_ms));
        QVERIFY(!QFile::exists(file()));
    }

    void aFileThatIsNoneIsToldAndMeasuringGoesOn() {
        QDir().mkpath(m_folder.filePath(QStringLiteral("cost")));
        QFile broken(file());
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("ladder,rung\nfirst,a\n");
        broken.close();
        open({quickLadder("first")});
        QTRY_COMPARE_WITH_TIMEOUT(m_page->messages().count(), 1, kPatience_ms);
        QVERIFY(m_page->messages().isVisible());
        QTest::mouseClick(&part<QPushButton>("measureEmpty"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(part<QTableWidget>("rungs").rowCount(), 3, kPatience_ms);
    }

    void anotherLanguageChangesTheTextsOfTheLaddersAndKeepsWhatWasMeasured() {
        const auto title = std::make_shared<std::string>("Title");
        openWith([title] {
            cost::Ladder ladder = quickLadder("first");
            ladder.title = *title;
            return std::vector{ladder};
        });
        QTest::mouseClick(&part<QPushButton>("measureEmpty"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(part<QTableWidget>("rungs").rowCount(), 3, kPatience_ms);
        QCOMPARE(part<QLabel>("title").text(), QStringLiteral("Title"));
        *title = "Titre";
        QEvent change(QEvent::LanguageChange);
        QCoreApplication::sendEvent(m_page.get(), &change);
        QCOMPARE(part<QLabel>("title").text(), QStringLiteral("Titre"));
        QCOMPARE(part<QTableWidget>("rungs").rowCount(), 3);
    }

    void aClickOnAPointChoosesItsRow() {
        QDir().mkpath(m_folder.filePath(QStringLiteral("cost")));
        QVERIFY(cost::writeCostFile(knownCosts(), file().toStdString()));
        open({quickLadder("contact-flow")});
        QTRY_COMPARE_WITH_TIMEOUT(part<QTableWidget>("rungs").rowCount(), 2, kPatience_ms);
        auto* chart = m_page->findChild<cost::CostChart*>();
        QTRY_VERIFY(chart->pointOf(QStringLiteral("ultrafast-3.2")).has_value());
        QSignalSpy clicked(chart, &cost::CostChart::rungClicked);
        const QPoint at = chart->pointOf(QStringLiteral("ultrafast-3.2"))->toPoint();
        QTest::mouseClick(chart->childAt(at), Qt::LeftButton, {}, chart->childAt(at)->mapFrom(chart, at));
        QCOMPARE(clicked.count(), 1);
        QCOMPARE(part<QTableWidget>("rungs").currentRow(), 1);
        const QString words = part<QLabel>("words").text();
        QVERIFY2(words.startsWith(QStringLiteral("ultrafast-3.2 takes 1.00")), qPrintable(words));
        QVERIFY2(words.contains(QStringLiteral("More accurate: dots, takes 18 times as long")),
                 qPrintable(words));
        QVERIFY(part<QLabel>("words").isVisible());
    }

    void theNumbersHaveRoomOnASmallScreen() {
        QDir().mkpath(m_folder.filePath(QStringLiteral("cost")));
        auto costs = knownCosts();
        costs.front().rungs[1].name = "fast-2-changed";
        costs.front().rungs[1].parameter = "scale 1/2, only where changed";
        QVERIFY(cost::writeCostFile(costs, file().toStdString()));
        open({quickLadder("contact-flow")});
        // What the window of 1024 x 700 leaves to a page.
        m_page->resize(950, 600);
        auto& table = part<QTableWidget>("rungs");
        QTRY_COMPARE_WITH_TIMEOUT(table.rowCount(), 2, kPatience_ms);
        QTRY_VERIFY(table.isVisible() && table.width() < 950);
        QTRY_VERIFY(!table.horizontalScrollBar()->isVisible());
        QCOMPARE(m_page->width(), 950);
        for (int column = 0; column < table.columnCount(); ++column)
            for (int row = 0; row < table.rowCount(); ++row) {
                const QTableWidgetItem& item = *table.item(row, column);
                const QRect needed = table.fontMetrics().boundingRect({0, 0, table.columnWidth(column), 1000},
                                                                      Qt::TextWordWrap, item.text());
                QTRY_VERIFY2(needed.width() <= table.columnWidth(column) &&
                                 needed.height() <= table.rowHeight(row),
                             qPrintable(QStringLiteral("%1: %2 x %3 px, has %4 x %5")
                                            .arg(item.text())
                                            .arg(needed.width())
                                            .arg(needed.height())
                                            .arg(table.columnWidth(column))
                                            .arg(table.rowHeight(row))));
            }
        // Nor is the chart squeezed for it.
        QVERIFY(m_page->findChild<cost::CostChart*>()->height() > 150);
    }

    void withoutACameraItOffersOneAndNothingCanBeSet() {
        open({quickLadder("contact-flow")});
        QVERIFY(!part<QComboBox>("rung").isVisible());
        QVERIFY(!part<QPushButton>("useBest").isEnabled());
    }

    void aTimeBudgetPicksTheBestRungAndSetsTheRunningCamera() {
        QDir().mkpath(m_folder.filePath(QStringLiteral("cost")));
        QVERIFY(cost::writeCostFile(knownCosts(), file().toStdString()));
        open({quickLadder("contact-flow")});
        openCamera();
        QTRY_COMPARE_WITH_TIMEOUT(rungOfCamera(), QStringLiteral("dots"), kPatience_ms);
        QTRY_VERIFY(part<QPushButton>("useBest").isEnabled()); // 8 ms: the quick one
        QTRY_VERIFY(part<QLabel>("words").text().startsWith(QStringLiteral("In use: dots.")));

        QTest::mouseClick(&part<QPushButton>("useBest"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(rungOfCamera(), QStringLiteral("ultrafast-3.2"), kPatience_ms);
        QTRY_COMPARE(part<QComboBox>("rung").currentData().toString(), QStringLiteral("ultrafast-3.2"));
        QTRY_VERIFY(part<QLabel>("words").text().startsWith(QStringLiteral("In use: ultrafast-3.2.")));

        auto& budget = part<QDoubleSpinBox>("budget");
        budget.setFocus();
        budget.selectAll();
        QTest::keyClicks(&budget, QStringLiteral("25"));
        QTest::keyClick(&budget, Qt::Key_Return);
        QTest::mouseClick(&part<QPushButton>("useBest"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(rungOfCamera(), QStringLiteral("dots"), kPatience_ms);

        budget.selectAll();
        QTest::keyClicks(&budget, QStringLiteral("0.5"));
        QTest::keyClick(&budget, Qt::Key_Return);
        QVERIFY(!part<QPushButton>("useBest").isEnabled());
    }

    void theRungOfTheCameraIsChosenByHand() {
        open({quickLadder("contact-flow")});
        openCamera();
        auto& rungs = part<QComboBox>("rung");
        QTRY_COMPARE_WITH_TIMEOUT(rungs.currentText(), QStringLiteral("dots"), kPatience_ms);
        rungs.setFocus();
        QTest::keyClick(&rungs, Qt::Key_Down);
        QTRY_COMPARE_WITH_TIMEOUT(rungOfCamera(), QStringLiteral("paper"), kPatience_ms);
    }
};

QTEST_MAIN(CostPageTest)
#include "cost_page_test.moc"
