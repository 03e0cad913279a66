// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "tests/widgets/touch/sample_records.h"
#include "widgets/base/theme.h"
#include "widgets/touch/safety_sign.h"
#include "widgets/touch/stiffness_gauge.h"
#include "widgets/touch/touch_texts.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QImage>
#include <QMimeData>
#include <QPainter>
#include <QSet>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace teleta;
using namespace teleta::touch;
using stiffness::Material;
using stiffness::Refusal;

namespace {

constexpr auto kNoBreakSpace = "\u00a0";

QString spaced(const char* text) {
    return QString::fromUtf8(text).replace(u'_', QString::fromUtf8(kNoBreakSpace));
}

/// A gauge on the screen.
struct Shown {
    explicit Shown(const std::optional<stiffness::TouchStiffness>& touch) {
        gauge.resize(480, 240);
        gauge.setTouch(touch);
    }
    [[nodiscard]] QImage draw() { return gauge.grab().toImage().convertToFormat(QImage::Format_RGB32); }
    [[nodiscard]] bool isInk(const QImage& image, const QPointF& point) const {
        return qGray(image.pixel(point.toPoint())) < 100;
    }
    StiffnessGauge gauge;
};

/// Events of a kind that an object gets.
class CountedEvents : public QObject {
public:
    CountedEvents(QObject& watched, QEvent::Type type)
        : m_type(type) {
        watched.installEventFilter(this);
    }
    [[nodiscard]] int count() const { return m_count; }
    bool eventFilter(QObject* /*watched*/, QEvent* event) override {
        m_count += event->type() == m_type ? 1 : 0;
        return false;
    }

private:
    QEvent::Type m_type;
    int m_count = 0;
};

/// Which pixels a safety shape covers.
QSet<int> silhouette(bool safe) {
    QImage image(48, 48, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintSafetyShape(painter, QRectF(image.rect()), safe, Qt::red);
    painter.end();
    QSet<int> covered;
    for (int i = 0; i < 48 * 48; ++i)
        if (image.pixel(i % 48, i / 48) != qRgb(255, 255, 255))
            covered << i;
    return covered;
}

} // namespace

/// The stiffness of the last touch.
class StiffnessGaugeTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }

    void theScaleIsLogarithmicFromAHundredToAHundredThousand() {
        const Shown shown(std::nullopt);
        const GaugeLayout layout = shown.gauge.layoutNow();
        QCOMPARE(layout.x(100.0), layout.bands.left());
        QCOMPARE(layout.x(1e5), layout.bands.right());
        const double decade = layout.bands.width() / 3.0;
        QVERIFY(std::abs(layout.x(1e3) - layout.x(100.0) - decade) < 1e-9);
        QVERIFY(std::abs(layout.x(1e4) - layout.x(1e3) - decade) < 1e-9);
        QCOMPARE(layout.x(3.0), layout.bands.left());
        QCOMPARE(layout.x(1e9), layout.bands.right());
    }

    void theBandsAreThoseOfTheMaterialsWithoutGaps() {
        const Shown shown(std::nullopt);
        const GaugeLayout layout = shown.gauge.layoutNow();
        QCOMPARE(layout.band(0).left(), layout.bands.left());
        QCOMPARE(layout.band(4).right(), layout.bands.right());
        for (std::size_t i = 0; i + 1 < 5; ++i)
            QVERIFY(std::abs(layout.band(i).right() - layout.band(i + 1).left()) < 1e-9);
        // Rubber to wood is the geometric mean of the paper's two objects.
        const double border = std::sqrt(7223.9 * 8562.9);
        QVERIFY(std::abs(layout.band(2).right() - layout.x(border)) < 0.01);
    }

    void numbersHaveThreeDigitsAndAUnit_data() {
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<QString>("text");
        QTest::newRow("sponge") << 282.0 << spaced("282_N/m");
        QTest::newRow("rubber sponge") << 1325.9 << spaced("1.33_kN/m");
        QTest::newRow("wood") << 8562.9 << spaced("8.56_kN/m");
        QTest::newRow("metal") << 34686.0 << spaced("34.7_kN/m");
    }
    void numbersHaveThreeDigitsAndAUnit() {
        QFETCH(double, stiffness);
        QFETCH(QString, text);
        const Shown shown(test::estimateOf(stiffness, 0.9 * stiffness, 1.1 * stiffness));
        QCOMPARE(GaugeTexts::headline(shown.gauge.content()), text);
    }

    void theEstimateAndItsIntervalAreWhereTheyBelong() {
        Shown shown(test::estimateOf(1000.0, 500.0, 2500.0));
        const QImage image = shown.draw();
        const GaugeLayout layout = shown.gauge.layoutNow();
        const double y = layout.interval.center().y();
        QVERIFY(shown.isInk(image, {layout.x(1000.0), layout.bands.center().y()}));
        QVERIFY(shown.isInk(image, {layout.x(1000.0), y}));
        QVERIFY(shown.isInk(image, {layout.x(600.0), y}));
        QVERIFY(shown.isInk(image, {layout.x(2300.0), y}));
        QVERIFY(!shown.isInk(image, {layout.x(400.0), y}));
        QVERIFY(!shown.isInk(image, {layout.x(3200.0), y}));
        QVERIFY(!shown.isInk(image, {layout.x(600.0), layout.bands.center().y()}));
    }

    void aBoundIsAnOpenArrowAndSaysAtLeast() {
        Shown shown(test::boundOf(9000.0));
        const QImage image = shown.draw();
        const GaugeLayout layout = shown.gauge.layoutNow();
        const double y = layout.interval.center().y();
        QVERIFY(shown.isInk(image, {layout.x(12000.0), y}));
        QVERIFY(shown.isInk(image, {layout.bands.right() - 3.0, y}));
        QVERIFY(!shown.isInk(image, {layout.x(7000.0), y}));
        // The head is open: two strokes with nothing between them.
        const double back = layout.bands.right() - 0.45 * layout.em;
        QVERIFY(!shown.isInk(image, {back, y + 0.22 * layout.em}));
        QVERIFY(shown.isInk(image, {back, y + 0.45 * layout.em}));
        QCOMPARE(GaugeTexts::headline(shown.gauge.content()), spaced("at least 9.00_kN/m (95 %)"));
        QVERIFY(GaugeTexts::material(*shown.gauge.content().touch).contains("taken as metal"));
    }

    void anIntervalThatDoesNotExcludeRigidIsOpenToo() {
        Shown shown(test::estimateOf(9000.0, 5000.0, std::nullopt));
        const QImage image = shown.draw();
        const GaugeLayout layout = shown.gauge.layoutNow();
        QVERIFY(shown.isInk(image, {layout.bands.right() - 3.0, layout.interval.center().y()}));
        QVERIFY(GaugeTexts::details(shown.gauge.content()).contains("rigid"));
        QVERIFY(GaugeTexts::material(*shown.gauge.content().touch).contains("not certain"));
    }

    void safeAndDangerDifferInColourWordAndShape() {
        Shown safe(test::estimateOf(282.0, 270.0, 295.0));
        Shown danger(test::estimateOf(7223.9, 7100.0, 7400.0));
        QVERIFY(safe.gauge.accessibleDescription().contains("SAFE"));
        QVERIFY(danger.gauge.accessibleDescription().contains("DANGER"));
        const base::StatusColours& colours = base::statusColours(safe.gauge.palette());
        const auto pixels = [](const QImage& image, const QRectF& room, const QColor& colour) {
            int found = 0;
            for (int x = qCeil(room.left()); x < room.right(); ++x)
                for (int y = qCeil(room.top()); y < room.bottom(); ++y)
                    found += image.pixelColor(x, y) == colour ? 1 : 0;
            return found;
        };
        const QRectF sign = safe.gauge.layoutNow().headline;
        const QImage safeImage = safe.draw(), dangerImage = danger.draw();
        QVERIFY(pixels(safeImage, sign, colours.live) > 40);
        QCOMPARE(pixels(safeImage, sign, colours.lost), 0);
        QVERIFY(pixels(dangerImage, sign, colours.lost) > 40);
        QCOMPARE(pixels(dangerImage, sign, colours.live), 0);
        QSet<int> onlyOne = silhouette(true);
        onlyOne.subtract(silhouette(false));
        QVERIFY(onlyOne.size() > 300);
    }

    void theAgeOfTheTouchIsSaidAndRepaintedOnceASecond() {
        Shown shown(test::estimateOf(282.0, 270.0, 295.0));
        QCOMPARE(GaugeTexts::age(shown.gauge.content()), QString());
        shown.gauge.show();
        QVERIFY(QTest::qWaitForWindowExposed(&shown.gauge));
        QCoreApplication::processEvents();
        CountedEvents paints(shown.gauge, QEvent::Paint);
        for (int tick = 0; tick < 90; ++tick) { // 3 s at 30 Hz
            shown.gauge.setAge(tick / 30.0);
            QCoreApplication::processEvents();
        }
        QCOMPARE(paints.count(), 3);
        QCOMPARE(GaugeTexts::age(shown.gauge.content()), QStringLiteral("2 s ago"));
        QVERIFY(shown.gauge.accessibleDescription().startsWith("SAFE; 2 s ago"));
        QVERIFY2(shown.gauge.figure().csv() == gaugeCsv(shown.gauge.content()), "a file has no age");
    }

    void anOldWordIsStaleInAmberUntilTheNextTouch() {
        Shown shown(test::estimateOf(282.0, 270.0, 295.0));
        const auto amber = [&shown] {
            const QImage image = shown.draw();
            const QRectF line = shown.gauge.layoutNow().material;
            const QColor stale = base::statusColours(shown.gauge.palette()).stale;
            int found = 0;
            for (int x = qCeil(line.center().x()); x < line.right(); ++x)
                for (int y = qCeil(line.top()); y < line.bottom(); ++y)
                    found += image.pixelColor(x, y) == stale ? 1 : 0;
            return found;
        };
        shown.gauge.setAge(GaugeTexts::kStale_s - 0.1);
        QVERIFY(!GaugeTexts::isStale(shown.gauge.content()));
        QCOMPARE(amber(), 0);
        shown.gauge.setAge(GaugeTexts::kStale_s);
        QCOMPARE(GaugeTexts::age(shown.gauge.content()), spaced("stale, 30 s ago"));
        QVERIFY(amber() > 20);
        shown.gauge.setAge(150.0);
        QCOMPARE(GaugeTexts::age(shown.gauge.content()), spaced("stale, 2 min ago"));
        shown.gauge.setRefusal(Refusal::tooFewSamples);
        QCOMPARE(GaugeTexts::age(shown.gauge.content()), QString());
    }

    void aLowGaugeKeepsTheVerdictAndTheScale() {
        Shown shown(test::estimateOf(1000.0, 500.0, 2500.0));
        int before = 3;
        for (int height = 240; height >= shown.gauge.minimumSizeHint().height(); --height) {
            shown.gauge.resize(shown.gauge.minimumSizeHint().width(), height);
            const GaugeLayout layout = shown.gauge.layoutNow();
            const QRectF all = shown.gauge.rect();
            for (const QRectF& part : {layout.headline, layout.material, layout.bands})
                QVERIFY2(part.height() > 0.0 && all.contains(part), qPrintable(QString::number(height)));
            const int parts = (layout.names.isEmpty() ? 0 : 1) + (layout.axis.isEmpty() ? 0 : 1) +
                              (layout.details.isEmpty() ? 0 : 1);
            QVERIFY2(parts <= before, qPrintable(QString::number(height)));
            before = parts;
        }
        QCOMPARE(before, 0);
        const QImage image = shown.draw();
        const GaugeLayout layout = shown.gauge.layoutNow();
        QVERIFY(shown.isInk(image, {layout.x(1000.0), layout.interval.center().y()}));
        QVERIFY(shown.isInk(image, {layout.x(600.0), layout.interval.center().y()}));
    }

    void everyRefusalHasItsReasonInWords() {
        QSet<QString> reasons;
        for (const Refusal refusal :
             {Refusal::notFinite, Refusal::notPositive, Refusal::negativeUncertainty, Refusal::badWindow,
              Refusal::noSamples, Refusal::windowNotReached, Refusal::tooFewSamples, Refusal::torqueUnchanged,
              Refusal::angleOpposesTorque, Refusal::tooQuick, Refusal::noTorques}) {
            StiffnessGauge gauge;
            gauge.setRefusal(refusal);
            const QString said = GaugeTexts::details(gauge.content());
            QVERIFY(said.endsWith(u'.'));
            QVERIFY(gauge.accessibleDescription().contains(said));
            reasons << said;
        }
        QCOMPARE(reasons.size(), 11);
    }

    void aRefusalTakesTheOldEstimateAway() {
        Shown shown(test::estimateOf(282.0, 270.0, 295.0));
        shown.gauge.setRefusal(Refusal::tooFewSamples);
        QVERIFY(!shown.gauge.content().touch);
        shown.gauge.setTouch(test::estimateOf(282.0, 270.0, 295.0));
        QVERIFY(!shown.gauge.content().refusal);
    }

    void withoutATouchItSaysWhatToDo() {
        StiffnessGauge gauge;
        QVERIFY(gauge.accessibleDescription().contains("Touch an object"));
        QVERIFY(gauge.figure().csv().isEmpty());
    }

    void aTouchStifferThanTheLinkIsSuspicious() {
        stiffness::TouchStiffness touch = test::boundOf(5000.0);
        touch.stifferThanLink = true;
        const Shown shown(touch);
        QVERIFY(shown.gauge.accessibleDescription().contains("check contact distance"));
    }

    void valuesBeyondTheScaleStayInThePicture() {
        for (const double stiffness : {3.0, 4e6}) {
            Shown shown(test::estimateOf(stiffness, 0.5 * stiffness, 2.0 * stiffness));
            const QImage image = shown.draw();
            const GaugeLayout layout = shown.gauge.layoutNow();
            QVERIFY(shown.isInk(image, {layout.x(stiffness), layout.interval.center().y()}));
        }
    }

    void theToolTipNamesTheBandUnderTheMouse() {
        const Shown shown(std::nullopt);
        const GaugeLayout layout = shown.gauge.layoutNow();
        const QString tip = shown.gauge.toolTipAt(layout.band(1).center());
        for (const char* part : {"rubber sponge", "611", "3.09", "SAFE", "level 2"})
            QVERIFY2(tip.contains(QLatin1String(part)), qPrintable(tip));
        QVERIFY(shown.gauge.toolTipAt(layout.band(4).center()).contains("metal: from"));
    }

    void theDataAreThoseOfTheCommandLine() {
        Shown shown(test::boundOf(9000.0));
        QCOMPARE(shown.gauge.figure().csv(),
                 QString("method,samples,delta_theta_rad,delta_torque_nm,total_stiffness_n_per_m,"
                         "total_stiffness_se,object_stiffness_n_per_m,object_stiffness_lower_95,"
                         "object_stiffness_upper_95,material,safe,level,reliable,warnings\n"
                         "regression,31,0,0,NA,NA,NA,9000,NA,metal,false,5,true,NA\n"));
    }

    void picturesAreForPaperWhateverTheThemeIs() {
        base::applyTheme(base::ThemeChoice::dark);
        Shown shown(test::estimateOf(282.0, 270.0, 295.0));
        const QTemporaryDir folder;
        for (const char* name : {"g.svg", "g.pdf", "g.png"})
            QVERIFY(base::saveFigure(shown.gauge.figure(), folder.filePath(name)).has_value());
        base::applyTheme(base::ThemeChoice::light);
        QFile pdf(folder.filePath("g.pdf"));
        QVERIFY(pdf.open(QIODevice::ReadOnly) && pdf.read(4) == "%PDF");
        const QImage png(folder.filePath("g.png"));
        QCOMPARE(png.size(), QSize(960, 480));
        QCOMPARE(png.pixelColor(2, 2), QColor(Qt::white));
        QSvgRenderer svg(folder.filePath("g.svg"));
        QVERIFY(svg.isValid());
        QFile text(folder.filePath("g.svg"));
        QVERIFY(text.open(QIODevice::ReadOnly));
        QVERIFY(!text.readAll().contains("<image"));
    }

    void copyPutsThePictureOnTheClipboard() {
        Shown shown(test::estimateOf(282.0, 270.0, 295.0));
        shown.gauge.show();
        QGuiApplication::clipboard()->clear();
        QTest::keySequence(&shown.gauge, QKeySequence::Copy);
        QVERIFY(QGuiApplication::clipboard()->mimeData()->hasImage());
        QVERIFY(QGuiApplication::clipboard()->mimeData()->hasFormat("image/svg+xml"));
    }
};

namespace {
const test::Registration<StiffnessGaugeTest> registration;
}
#include "stiffness_gauge_test.moc"
