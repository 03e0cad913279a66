// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/theme.h"
#include "widgets/bracelet/bracelet_view.h"

#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include <limits>
#include <vector>

using teleta::bracelet::BraceletView;
using teleta::core::Intensities;

namespace {

using Held = std::optional<std::size_t>;

struct HoldLog {
    explicit HoldLog(BraceletView& view) {
        QObject::connect(&view, &BraceletView::held, [this](Held tactor) { seen.push_back(tactor); });
    }
    std::vector<Held> seen;
};

} // namespace

/// The picture of the bracelet: what it shows, and that a held tactor is always let go.
class BraceletViewTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { teleta::base::applyTheme(teleta::base::ThemeChoice::light); }

    void init() {
        m_view = std::make_unique<BraceletView>();
        m_view->resize(400, 220);
        m_view->show();
        m_view->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_view.get()));
        m_view->setFocus();
    }

    void cleanup() { m_view.reset(); }

    void tactorsGoRoundTheArmInAZigzag() {
        const auto layout = m_view->layoutNow();
        for (std::size_t i = 1; i < teleta::core::kTactors; ++i) {
            QVERIFY(layout.centre[i].x() > layout.centre[i - 1].x() + 1.9 * layout.radius * 0.5);
            QCOMPARE(layout.centre[i].y() > layout.centre[0].y(), i % 2 == 1);
        }
        for (const QPointF& centre : layout.centre)
            QVERIFY(layout.arm.contains(centre));
    }

    void aStrongTactorIsFilledFurtherThanAWeakOne() {
        m_view->setIntensities({1.0, 0.25, 0.0, 0.0, 0.0, 0.0});
        const QImage image = m_view->grab().toImage();
        const auto layout = m_view->layoutNow();
        const QColor accent = m_view->palette().color(QPalette::Highlight);
        const auto at = [&](std::size_t tactor, double share) {
            const QPointF p = layout.centre[tactor] + QPointF(0.0, -share * layout.radius);
            return image.pixelColor(p.toPoint());
        };
        QCOMPARE(at(0, 0.85), accent);
        QVERIFY(at(1, 0.85) != accent); // a quarter of the area: half of the radius
        QVERIFY(at(2, 0.3) != accent);
    }

    void aPreviewIsOutlinedAndNotFilled() {
        m_view->setTitle("Circle");
        m_view->setIntensities({1.0, 0.0, 0.0, 0.0, 0.0, 0.0});
        m_view->setPreview(true);
        const auto at = [this] {
            const auto layout = m_view->layoutNow();
            return m_view->grab().toImage().pixelColor(
                (layout.centre[0] + QPointF(0.0, -0.8 * layout.radius)).toPoint());
        };
        const QColor accent = m_view->palette().color(QPalette::Highlight);
        QVERIFY(at() != accent);
        QVERIFY(m_view->accessibleDescription().contains("Circle: preview"));
        m_view->setPreview(false);
        QCOMPARE(at(), accent);
        QVERIFY(!m_view->accessibleDescription().contains("preview"));
    }

    void aNoteThatAlarmsHasTheColourOfWhatIsLost() {
        m_view->setNote("STOP is engaged: the bracelet is off.");
        const QColor lost = teleta::base::statusColours(m_view->palette()).lost;
        const auto hasIt = [&] {
            const QImage image = m_view->grab().toImage();
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    if (image.pixelColor(x, y) == lost)
                        return true;
            return false;
        };
        QVERIFY(!hasIt());
        m_view->setAlarming(true);
        QVERIFY(hasIt());
    }

    void saysInWordsWhatVibrates() {
        m_view->setTitle(QStringLiteral("Circle"));
        m_view->setIntensities({0.0, 0.5, 0.0, 0.0, 0.0, 1.0});
        QVERIFY(m_view->accessibleDescription().contains(QStringLiteral("Circle")));
        QVERIFY(m_view->accessibleDescription().contains(QStringLiteral("motor 2: 50 %")));
        QVERIFY(m_view->accessibleDescription().contains(QStringLiteral("motor 6: 100 %")));
        QVERIFY(!m_view->accessibleDescription().contains(QStringLiteral("motor 1")));
    }

    void whatIsNoIntensityIsOff() {
        m_view->setIntensities({std::numeric_limits<double>::quiet_NaN(), -1.0, 7.0, 0.0, 0.0, 0.0});
        QVERIFY(!m_view->accessibleDescription().contains(QStringLiteral("motor 1")));
        QVERIFY(!m_view->accessibleDescription().contains(QStringLiteral("motor 2")));
        QVERIFY(m_view->accessibleDescription().contains(QStringLiteral("motor 3: 100 %")));
    }

    void isNotHeldUnlessThatIsAllowed() {
        const HoldLog log(*m_view);
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, m_view->layoutNow().centre[2].toPoint());
        QTest::mouseRelease(m_view.get(), Qt::LeftButton);
        QTest::keyClick(m_view.get(), Qt::Key_1);
        QVERIFY(log.seen.empty());
    }

    void theMouseHoldsATactorUntilItLetsGo() {
        m_view->setHoldable(true);
        const HoldLog log(*m_view);
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, m_view->layoutNow().centre[2].toPoint());
        QVERIFY(log.seen == std::vector<Held>{2U});
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, QPoint(1, 1));
        QVERIFY((log.seen == std::vector<Held>{2U, std::nullopt}));
    }

    void theKeysHoldATactorUntilTheyAreUp() {
        m_view->setHoldable(true);
        const HoldLog log(*m_view);
        QTest::keyPress(m_view.get(), Qt::Key_6);
        QTest::keyRelease(m_view.get(), Qt::Key_6);
        QTest::keyClick(m_view.get(), Qt::Key_7);
        QVERIFY((log.seen == std::vector<Held>{5U, std::nullopt}));
    }

    void losingTheFocusLetsGo() {
        m_view->setHoldable(true);
        const HoldLog log(*m_view);
        QTest::keyPress(m_view.get(), Qt::Key_1);
        m_view->clearFocus();
        QVERIFY((log.seen == std::vector<Held>{0U, std::nullopt}));
    }

    void hidingOrForbiddingLetsGo() {
        m_view->setHoldable(true);
        const HoldLog log(*m_view);
        QTest::keyPress(m_view.get(), Qt::Key_1);
        m_view->setHoldable(false);
        QVERIFY((log.seen == std::vector<Held>{0U, std::nullopt}));
        m_view->setHoldable(true);
        QTest::keyPress(m_view.get(), Qt::Key_2);
        m_view->hide();
        QVERIFY(!log.seen.back());
        QCOMPARE(log.seen.size(), 4U);
    }

private:
    std::unique_ptr<BraceletView> m_view;
};

QTEST_MAIN(BraceletViewTest)
#include "bracelet_view_test.moc"
