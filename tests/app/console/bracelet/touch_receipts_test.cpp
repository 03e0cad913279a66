// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/feedback_panel.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/touch/touch_record.h"
#include "tests/app/console/bracelet/patient_bracelet.h"

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <memory>

using namespace teleta;
using console::BraceletChoice;
using console::BraceletService;
using console::TouchReceipt;

namespace {

constexpr std::int64_t kOffset_ns = 5'000'000'000;
constexpr std::int64_t kBound_ns = 21'000'000;
constexpr std::int64_t kLate_ns = 20'000;

playback::Program halfDrive(const std::string& /*id*/ = {}) {
    core::Intensities half{};
    half.fill(0.5);
    return {[half](double) { return half; }, 600.0};
}

} // namespace

/// What is kept of each touch: when it was read, evaluated, sent and felt, and how well a site's clock is
/// known.
class TouchReceiptsTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    core::StopSwitch m_stop;
    std::unique_ptr<BraceletService> m_station;

    /// late_ns: by which it came from a site; 0: it was read here.
    std::int64_t touch(std::uint64_t number, std::int64_t late_ns = 0) {
        pipeline::TouchRecord record;
        record.number = number;
        record.ready_ns = core::steadyNow_ns();
        record.arrived_ns = late_ns == 0 ? 0 : record.ready_ns + late_ns;
        record.stiffness.emplace();
        record.stiffness->material = stiffness::Material::metal;
        m_station->feedback()->onTouch(record);
        return record.ready_ns;
    }
    [[nodiscard]] QStringList savedRow(const TouchReceipt& receipt) const {
        const QString path = m_folder.filePath(QStringLiteral("one.csv"));
        if (!console::writeReceipts(path.toStdString(), {&receipt, 1}))
            return {};
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return {};
        (void)file.readLine();
        return QString::fromUtf8(file.readLine()).trimmed().split(QLatin1Char(','));
    }

private slots:
    void initTestCase() { qputenv("XDG_CONFIG_HOME", m_folder.path().toLocal8Bit()); }
    void init() {
        m_station = test::patientBracelet(m_stop);
        m_station->choose(BraceletChoice::simulated);
        QTRY_VERIFY((m_station->tick(), m_station->isReady()));
        m_station->setLibrary(halfDrive);
        m_station->setMap(pattern::PatternMap::defaults());
        m_station->setMode(pipeline::FeedbackMode::stiffness);
    }
    void cleanup() { m_station.reset(); }

    void aTouchAtASiteCarriesTheBoundOfItsClock() {
        console::FeedbackPanel panel(*m_station);
        panel.show();
        auto* save = panel.findChild<QPushButton*>(QStringLiteral("saveTouchTimes"));
        QVERIFY(save != nullptr && save->isHidden());
        m_station->setSiteClock(site::ClockOffset{.offset_ns = kOffset_ns, .bound_ns = kBound_ns});
        const std::int64_t read_ns = touch(7, kLate_ns);
        QTRY_VERIFY((m_station->tick(), m_station->lastEvent() && m_station->lastEvent()->onset_s));
        QCOMPARE(m_station->receipts().size(), 1U);
        const TouchReceipt receipt = m_station->receipts().front();
        QCOMPARE(m_station->touchToSkin()->bound_s, 0.021);
        QVERIFY(save->isVisible());
        const auto labels = panel.findChildren<QLabel*>();
        const auto says = [&labels](const QString& text) {
            return std::ranges::any_of(labels,
                                       [&](const QLabel* label) { return label->text().contains(text); });
        };
        QVERIFY(says(QStringLiteral("± 21")));

        const QStringList row = savedRow(receipt);
        QCOMPARE(row.size(), 11);
        QCOMPARE(row[0], QStringLiteral("7"));
        QCOMPARE(row[1], QStringLiteral("metal"));
        QCOMPARE(row[3], QStringLiteral("played"));
        QCOMPARE(row[4].toLongLong(), read_ns);
        QCOMPARE(row[5].toLongLong(), read_ns + kOffset_ns);
        QCOMPARE(row[6].toDouble(), 0.021);
        QCOMPARE(row[7].toDouble(), 20e-6);
        QVERIFY(row[8].toDouble() >= 0.0);
        QVERIFY(row[9].toDouble() >= row[8].toDouble());
        QVERIFY(row[10].toDouble() >= row[9].toDouble());
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
            return label->toolTip().contains(QStringLiteral("Arrived at the console: "));
        }));
    }

    void aTouchHereHasOneClock() {
        (void)touch(1);
        QTRY_VERIFY((m_station->tick(), m_station->lastEvent() && m_station->lastEvent()->onset_s));
        QCOMPARE(m_station->touchToSkin()->bound_s, 0.0);
        const QStringList row = savedRow(m_station->receipts().front());
        QCOMPARE(row[5], QStringLiteral("NA"));
        QCOMPARE(row[6], QStringLiteral("NA"));
        QCOMPARE(row[7], QStringLiteral("NA"));
    }

    void whatWasNotPlayedSaysWhy() {
        TouchReceipt receipt;
        receipt.sent.unknownStiffness = true;
        QCOMPARE(savedRow(receipt).mid(1, 3), (QStringList{"unknown", "", "no_pattern"}));
        receipt.sent.patternId = "mine";
        QCOMPARE(savedRow(receipt)[3], QStringLiteral("sent"));
        receipt.sent.refused = true;
        QCOMPARE(savedRow(receipt)[3], QStringLiteral("refused"));
        receipt.sent.missing = true;
        QCOMPARE(savedRow(receipt)[3], QStringLiteral("missing"));
        receipt.sent.shape = contour::Shape::circle;
        QCOMPARE(savedRow(receipt)[1], QStringLiteral("circle"));
        QCOMPARE(savedRow(receipt)[10], QStringLiteral("NA"));
    }

    void forgettingKeepsTheReceipts() {
        (void)touch(1);
        QTRY_VERIFY((m_station->tick(), !m_station->receipts().empty()));
        m_station->forgetFeedback();
        (void)touch(2);
        QTRY_VERIFY((m_station->tick(), m_station->receipts().size() == 2U));
        QCOMPARE(m_station->receipts().back().sent.touch, 2U);
    }
};

QTEST_MAIN(TouchReceiptsTest)
#include "touch_receipts_test.moc"
