// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/console/operate/operate_bench.h"
#include "widgets/tactile/tare_question.h"

#include <QMessageBox>
#include <QPushButton>

using namespace teleta;

/// A tare on the Operate page while a plate presses on the array, and while nothing does.
class TareQuestionTest : public test::OperateBench {
    Q_OBJECT

    [[nodiscard]] std::shared_ptr<pipeline::TouchChannel> array() const {
        const auto* item = m_sources->active();
        return item != nullptr && item->isOpen() ? item->array() : nullptr;
    }
    [[nodiscard]] std::size_t loaded() const {
        return array() == nullptr
                   ? 0
                   : tactile::loadedTaxels(array()->snapshot(), array()->settings().features.threshold_N)
                         .loaded;
    }
    [[nodiscard]] bool isTared() const { return !array()->settings().conditioning.tare.empty(); }
    [[nodiscard]] QMessageBox* question() const { return m_page->findChild<QMessageBox*>("tareUnderLoad"); }
    void pressTare() { QTest::mouseClick(m_page->findChild<QPushButton*>("tareNow"), Qt::LeftButton); }

private slots:
    void init() {
        makePage();
        m_page->show();
        m_page->docks().bringForward(QStringLiteral("processing"));
        m_sources->open(app::SceneRequest{.path = ":/scenes/tactile-even-load.toml"});
    }
    void cleanup() { closePage(); }

    void isAskedAboutUnderLoadAndOnlyDoneByThatAnswer() {
        QVERIFY(comes([this] { return loaded() == 84; }));
        pressTare();
        QVERIFY(question() != nullptr);
        QCOMPARE(question()->text(), QString("84 of 84 taxels are under load."));
        QTest::keyClick(question(), Qt::Key_Return);
        QVERIFY(comes([this] { return question() == nullptr; }));
        QVERIFY(!isTared());
        pressTare();
        for (QAbstractButton* button : question()->buttons())
            if (question()->buttonRole(button) == QMessageBox::AcceptRole)
                QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(comes([this] { return isTared(); }));
    }

    void isDoneAtOnceWithoutLoad() {
        QVERIFY(comes([this] { return array() != nullptr && array()->snapshot().framesProcessed > 0; }));
        QCOMPARE(loaded(), std::size_t(0));
        pressTare();
        QVERIFY(question() == nullptr);
        QVERIFY(comes([this] { return isTared(); }));
    }
};

QTEST_MAIN(TareQuestionTest)
#include "tare_question_test.moc"
