// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/base/tokens.h"
#include "widgets/calibrate/step_list.h"

#include <QApplication>
#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <memory>

using namespace teleta;
using namespace teleta::calibrate;

class StepListTest : public QObject {
    Q_OBJECT

    std::unique_ptr<StepList> m_list;

    [[nodiscard]] QString spoken(int step) const {
        return m_list->item(step)->data(Qt::AccessibleTextRole).toString();
    }
    [[nodiscard]] QImage rowImage(int step) const {
        return m_list->viewport()->grab(m_list->visualItemRect(m_list->item(step))).toImage();
    }
    [[nodiscard]] int pixelsOf(int step, const QColor& colour) const {
        const QImage image = rowImage(step);
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += image.pixelColor(x, y) == colour ? 1 : 0;
        return count;
    }

private slots:
    void init() {
        base::applyTheme(base::ThemeChoice::light);
        m_list = std::make_unique<StepList>(3);
        m_list->setName(0, "Motors");
        m_list->setName(1, "Camera");
        m_list->setName(2, "Gains");
        m_list->resize(220, 300);
        m_list->show();
        QVERIFY(QTest::qWaitForWindowActive(m_list.get()));
    }
    void cleanup() {
        m_list.reset();
        base::applyTheme(base::ThemeChoice::light);
    }

    void everyStateHasAWord() {
        QCOMPARE(spoken(0), QString("1. Motors: to do"));
        m_list->setReading(0, {.state = StepState::toDo, .number = 2, .of = 6});
        QCOMPARE(spoken(0), QString("1. Motors: 2 of 6 done"));
        m_list->setReading(0, {.state = StepState::running, .number = 3, .of = 6, .share = 0.4});
        QCOMPARE(spoken(0), QString("1. Motors: running: 3 of 6"));
        m_list->setReading(0, {.state = StepState::running, .number = 1, .of = 1});
        QCOMPARE(spoken(0), QString("1. Motors: running"));
        m_list->setReading(1, {.state = StepState::notSaved});
        QCOMPARE(spoken(1), QString("2. Camera: not saved"));
        m_list->setReading(1, {.state = StepState::done, .number = 6, .of = 6});
        QCOMPARE(spoken(1), QString("2. Camera: done"));
        m_list->setReading(2, {.state = StepState::failed});
        QCOMPARE(spoken(2), QString("3. Gains: failed"));
    }

    void everyStateHasAColour_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void everyStateHasAColour() {
        QFETCH(bool, dark);
        base::applyTheme(dark ? base::ThemeChoice::dark : base::ThemeChoice::light);
        QCoreApplication::processEvents();
        const base::StatusColours& colours = base::statusColours(m_list->palette());
        const std::pair<StepState, QColor> all[] = {
            {StepState::toDo, colours.neutral},
            {StepState::running, m_list->palette().color(QPalette::Highlight)},
            {StepState::notSaved, colours.stale},
            {StepState::done, colours.live},
            {StepState::failed, colours.lost}};
        for (const auto& [state, colour] : all) {
            m_list->setReading(1, {.state = StepState::toDo});
            const int before = pixelsOf(1, colour);
            m_list->setReading(1, {.state = state});
            QVERIFY(pixelsOf(1, colour) > (state == StepState::toDo ? 100 : before + 100));
        }
    }

    void aBarShowsTheShareOfWhatRuns() {
        const QColor accent = m_list->palette().color(QPalette::Highlight);
        m_list->setReading(1, {.state = StepState::running});
        const int without = pixelsOf(1, accent);
        const QImage image = rowImage(1);
        const double bar = base::grid(m_list.get(), base::kStripe) * image.devicePixelRatio();
        for (const double share : {0.25, 0.5, 1.0, 7.0}) {
            m_list->setReading(1, {.state = StepState::running, .share = share});
            const double expected = std::min(share, 1.0) * image.width() * bar;
            QVERIFY(std::abs(pixelsOf(1, accent) - without - expected) <= 2.0 * bar);
        }
        m_list->setReading(1, {.state = StepState::running, .share = 0.0});
        QCOMPARE(pixelsOf(1, accent), without);
    }

    void keysChooseAStep() {
        m_list->setCurrentRow(0);
        m_list->setFocus();
        QSignalSpy chosen(m_list.get(), &QListWidget::currentRowChanged);
        QTest::keyClick(m_list.get(), Qt::Key_Down);
        QTest::keyClick(m_list.get(), Qt::Key_Down);
        QCOMPARE(m_list->currentRow(), 2);
        QCOMPARE(chosen.size(), 2);
        QTest::mouseClick(m_list->viewport(), Qt::LeftButton, {},
                          m_list->visualItemRect(m_list->item(1)).center());
        QCOMPARE(m_list->currentRow(), 1);
    }
};

namespace {
const teleta::test::Registration<StepListTest> kRegistered;
}

#include "step_list_test.moc"
