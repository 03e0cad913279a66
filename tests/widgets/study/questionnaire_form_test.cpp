// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/standard_questionnaire.h"
#include "tests/widgets/test_registry.h"
#include "widgets/study/participant/answer_button.h"
#include "widgets/study/participant/participant_window.h"
#include "widgets/study/participant/questionnaire_form.h"
#include "widgets/study/participant/questionnaire_item_view.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <memory>

using namespace teleta;
using study::ItemAnswer;
using study::ItemKind;
using study::ParticipantScene;
using study::ParticipantWindow;
using study::QuestionnaireForm;
using study::QuestionnaireItemView;
using State = ParticipantScene::State;

namespace {

QPointingDevice* touchScreen() {
    static QPointingDevice* device = QTest::createTouchDevice();
    return device;
}

/// A scale, choices, and a text that may be left out.
study::Questionnaire effort() {
    study::QuestionnaireItem hard;
    hard.id = "hard";
    hard.kind = ItemKind::likert;
    hard.question = "How hard was it?";
    hard.points = 7;
    hard.low = "very easy";
    hard.high = "very hard";
    study::QuestionnaireItem hand;
    hand.id = "hand";
    hand.kind = ItemKind::choice;
    hand.question = "Which hand do you write with?";
    hand.choices = {{"l", "Left"}, {"r", "Right"}, {"b", "Both"}};
    study::QuestionnaireItem more;
    more.id = "more";
    more.kind = ItemKind::text;
    more.question = "Anything else?";
    more.required = false;
    return {"effort", "Effort", study::QuestionnaireTime::afterSession, {hard, hand, more}};
}

} // namespace

/// The questionnaire in the participant's window, by keyboard, mouse and touch.
class QuestionnaireFormTest : public QObject {
    Q_OBJECT

    std::unique_ptr<ParticipantWindow> m_window;
    std::vector<std::vector<ItemAnswer>> m_handedOver;
    int m_presses = 0;

    [[nodiscard]] QuestionnaireForm& form() { return m_window->questionnaire(); }
    [[nodiscard]] QuestionnaireItemView& item(std::size_t index) { return *form().items().at(index); }
    static QWidget* focused() { return QApplication::focusWidget(); }

private slots:
    void init() {
        m_presses = 0;
        m_handedOver.clear();
        m_window = std::make_unique<ParticipantWindow>([] { return std::int64_t(1); });
        m_window->setChoices({{"A", "a", {}}, {"B", "b", {}}});
        connect(m_window.get(), &ParticipantWindow::questionnaireAnswered, this,
                [this](const std::vector<ItemAnswer>& answers) { m_handedOver.push_back(answers); });
        connect(m_window.get(), &ParticipantWindow::pressed, this, [this] { ++m_presses; });
        m_window->resize(700, 700);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_window->setScene({.state = State::questionnaire});
        m_window->setQuestionnaire(effort());
    }
    void cleanup() { m_window.reset(); }

    void isFilledInByKeyboardAlone() {
        QTest::keyClick(focused(), Qt::Key_5);
        QCOMPARE(item(0).value(), std::optional<std::string>("5"));
        QTest::keyClick(focused(), Qt::Key_Right);
        QCOMPARE(item(0).value(), std::optional<std::string>("6"));
        QTest::keyClick(focused(), Qt::Key_Tab);
        QTest::keyClick(focused(), Qt::Key_2);
        QCOMPARE(item(1).value(), std::optional<std::string>("r"));
        QTest::keyClick(focused(), Qt::Key_Tab);
        QTest::keyClicks(focused(), QStringLiteral("no 1"));
        QCOMPARE(item(2).value(), std::optional<std::string>("no 1"));
        QTest::keyClick(focused(), Qt::Key_Return, Qt::ControlModifier);
        QCOMPARE(m_handedOver.size(), std::size_t(1));
        QCOMPARE(m_handedOver[0].size(), std::size_t(3));
        QCOMPARE(m_handedOver[0][0].value, std::optional<std::string>("6"));
        QCOMPARE(m_handedOver[0][1].item, std::string("hand"));
        QCOMPARE(m_presses, 0);
    }

    void aScaleFromZeroToHundredTakesDigitsArrowsAndTheMouse() {
        m_window->resize(1100, 800);
        m_window->setQuestionnaire(study::standardQuestionnaire(study::StandardQuestionnaire::nasaTlx));
        QCOMPARE(item(0).buttons().size(), study::kScalePoints);
        QTest::keyClick(focused(), Qt::Key_7);
        QCOMPARE(item(0).value(), std::optional<std::string>("70"));
        QTest::keyClick(focused(), Qt::Key_Right);
        QCOMPARE(item(0).value(), std::optional<std::string>("75"));
        QTest::keyClick(focused(), Qt::Key_Left);
        QTest::keyClick(focused(), Qt::Key_Left);
        QCOMPARE(item(0).value(), std::optional<std::string>("65"));
        QTest::keyClick(focused(), Qt::Key_Tab);
        QVERIFY(item(1).isAncestorOf(focused()));
        QTest::keyClick(focused(), Qt::Key_0);
        QCOMPARE(item(1).value(), std::optional<std::string>("0"));
        QTest::mouseClick(item(2).buttons()[20], Qt::LeftButton);
        QCOMPARE(item(2).value(), std::optional<std::string>("100"));
        QVERIFY(item(2).buttons()[20]->accessibleName().endsWith(QStringLiteral("100 of 100")));
        // Digits of a scale are tenths: none of them is out of place.
        for (int digit = 1; digit <= 9; ++digit) {
            QTest::keyClick(item(3).buttons()[0], static_cast<Qt::Key>(Qt::Key_0 + digit));
            QCOMPARE(item(3).value(), std::optional<std::string>(std::to_string(10 * digit)));
        }
        QTest::mouseClick(form().findChild<QPushButton*>("questionnaireDone"), Qt::LeftButton);
        QVERIFY(m_handedOver.empty());
        QTest::keyClick(focused(), Qt::Key_5);
        QTest::keyClick(focused(), Qt::Key_Tab);
        QTest::keyClick(focused(), Qt::Key_6);
        QTest::keyClick(focused(), Qt::Key_Return, Qt::ControlModifier);
        QCOMPARE(m_handedOver.size(), std::size_t(1));
        QCOMPARE(m_handedOver[0][5].value, std::optional<std::string>("60"));
    }

    void aPairIsChosenBySideAndKeepsItsShownOrder() {
        study::Questionnaire weighted = study::shownQuestionnaire(
            study::standardQuestionnaire(study::StandardQuestionnaire::nasaTlxWeighted), 5);
        weighted.items.erase(weighted.items.begin(), weighted.items.begin() + 6);
        m_window->setQuestionnaire(weighted);
        const auto& first = weighted.items[0].choices;
        QCOMPARE(item(0).buttons().size(), std::size_t(2));
        QVERIFY(item(0).buttons()[0]->text().contains(QString::fromStdString(first[0].text)));
        QTest::keyClick(focused(), Qt::Key_2);
        QCOMPARE(item(0).value(), std::optional(first[1].id));
        QTest::keyClick(focused(), Qt::Key_3);
        QCOMPARE(item(0).value(), std::optional(first[1].id));
        QTest::keyClick(focused(), Qt::Key_Left);
        QCOMPARE(item(0).value(), std::optional(first[0].id));
        QTest::mouseClick(item(1).buttons()[1], Qt::LeftButton);
        QCOMPARE(item(1).value(), std::optional(weighted.items[1].choices[1].id));
        for (QAbstractButton* button : item(1).buttons())
            QVERIFY(button->height() >= 40 && button->width() >= 40);
    }

    void keysOfTheLastTrialFillNothingIn() {
        m_window->setScene({.state = State::answering, .answersOpen = true});
        QTest::keyPress(focused(), Qt::Key_2);
        m_window->setScene({.state = State::questionnaire});
        QKeyEvent held(QEvent::KeyPress, Qt::Key_2, Qt::NoModifier, QStringLiteral("2"), true);
        QApplication::sendEvent(focused(), &held);
        QTest::keyRelease(focused(), Qt::Key_2);
        QTest::keyClick(focused(), Qt::Key_Space);
        QVERIFY(!item(0).value());
        QTest::keyClick(focused(), Qt::Key_Tab);
        QVERIFY(item(0).isAncestorOf(focused()));
        QApplication::sendEvent(focused(), &held);
        QVERIFY(!item(0).value());

        study::Questionnaire text = effort();
        std::swap(text.items.front(), text.items.back());
        m_window->setQuestionnaire(text);
        QApplication::sendEvent(focused(), &held);
        QTest::keyClick(focused(), Qt::Key_Space);
        QVERIFY(!item(0).value());
        QTest::keyClicks(focused(), QStringLiteral("4"));
        QTest::keyClicks(focused(), QStringLiteral(" 2"));
        QCOMPARE(item(0).value(), std::optional<std::string>("4 2"));
    }

    void theNextQuestionnaireTakesTheKeyboard() {
        m_window->setScene({.state = State::questionnaire, .questionnaireLocked = true});
        study::Questionnaire next = effort();
        next.items.resize(1);
        m_window->setQuestionnaire(next);
        m_window->setScene({.state = State::questionnaire});
        QTest::keyClick(focused(), Qt::Key_3);
        QCOMPARE(item(0).value(), std::optional<std::string>("3"));
        m_window->setScene({.state = State::questionnaire, .questionnaireLocked = true});
        m_window->setScene({.state = State::questionnaire});
        QTest::keyClick(focused(), Qt::Key_5);
        QCOMPARE(item(0).value(), std::optional<std::string>("3"));
        QTest::keyClick(focused(), Qt::Key_Tab);
        QTest::keyClick(focused(), Qt::Key_5);
        QCOMPARE(item(0).value(), std::optional<std::string>("5"));
    }

    void isFilledInByTouch() {
        const auto touch = [&](QWidget* target) {
            QTest::touchEvent(target, touchScreen()).press(0, target->rect().center(), target);
            QTest::touchEvent(target, touchScreen()).release(0, target->rect().center(), target);
        };
        touch(item(0).buttons()[2]);
        touch(item(1).buttons()[0]);
        touch(form().findChild<QPushButton*>("questionnaireDone"));
        QCOMPARE(m_handedOver.size(), std::size_t(1));
        QCOMPARE(m_handedOver[0][0].value, std::optional<std::string>("3"));
        QCOMPARE(m_handedOver[0][1].value, std::optional<std::string>("l"));
        QVERIFY(!m_handedOver[0][2].value);
        QCOMPARE(m_presses, 0);
    }

    void aTargetIsLargeEnoughForAFinger() {
        for (QAbstractButton* button : item(0).buttons())
            QVERIFY2(button->height() >= 40 && button->width() >= 40, qPrintable(button->text()));
        for (QAbstractButton* button : item(1).buttons())
            QVERIFY(button->height() >= 40);
    }

    void whatIsMissingIsSaidAtItsQuestionAndNothingIsHandedOver() {
        QTest::mouseClick(item(0).buttons()[6], Qt::LeftButton);
        QTest::mouseClick(form().findChild<QPushButton*>("questionnaireDone"), Qt::LeftButton);
        QVERIFY(m_handedOver.empty());
        const auto problems = [&](std::size_t index) {
            QStringList shown;
            for (const QLabel* label : item(index).findChildren<QLabel*>()) {
                if (label->isVisible() && label->text().contains(QStringLiteral("Please answer")))
                    shown << label->text();
            }
            return shown.size();
        };
        QCOMPARE(problems(0), 0);
        QCOMPARE(problems(1), 1);
        QVERIFY(item(1).isAncestorOf(focused()));
        QTest::keyClick(focused(), Qt::Key_3);
        QCOMPARE(problems(1), 0);
        QTest::mouseClick(form().findChild<QPushButton*>("questionnaireDone"), Qt::LeftButton);
        QCOMPARE(m_handedOver.size(), std::size_t(1));
    }

    void anOptionalScaleCanBeLeftOutAgain() {
        study::Questionnaire optional = effort();
        optional.items.resize(1);
        optional.items[0].required = false;
        m_window->setQuestionnaire(optional);
        QTest::mouseClick(item(0).buttons()[3], Qt::LeftButton);
        QCOMPARE(item(0).value(), std::optional<std::string>("4"));
        QTest::mouseClick(item(0).buttons().back(), Qt::LeftButton);
        QVERIFY(!item(0).value());
        QTest::mouseClick(form().findChild<QPushButton*>("questionnaireDone"), Qt::LeftButton);
        QCOMPARE(m_handedOver.size(), std::size_t(1));
        QVERIFY(!m_handedOver[0][0].value);
    }

    void whatIsBeingKeptCannotBeChangedAndStaysFilledInWhenItCouldNotBeKept() {
        QTest::mouseClick(item(0).buttons()[1], Qt::LeftButton);
        m_window->setScene({.state = State::questionnaire, .questionnaireLocked = true});
        QTest::mouseClick(item(0).buttons()[5], Qt::LeftButton);
        QTest::mouseClick(form().findChild<QPushButton*>("questionnaireDone"), Qt::LeftButton);
        QVERIFY(m_handedOver.empty());
        m_window->setScene(
            {.state = State::questionnaire, .questionnaireProblem = QStringLiteral("not kept")});
        QCOMPARE(item(0).value(), std::optional<std::string>("2"));
        bool said = false;
        for (const QLabel* label : form().findChildren<QLabel*>())
            said = said || (label->isVisible() && label->text() == QStringLiteral("not kept"));
        QVERIFY(said);
    }

    void theAnswersOfTrialsAreHiddenMeanwhileAndTakeTheKeyboardAgainAfterwards() {
        QVERIFY(!m_window->buttons()[0]->isVisible());
        QTest::mouseClick(m_window.get(), Qt::LeftButton, {}, QPoint(3, 3));
        QCOMPARE(m_presses, 0);
        m_window->setScene({.state = State::answering, .answersOpen = true});
        QVERIFY(m_window->buttons()[0]->isVisible());
        QVERIFY(!form().isVisible());
        QTest::keyClick(focused(), Qt::Key_1);
        QCOMPARE(m_presses, 1);
    }
};

static const test::Registration<QuestionnaireFormTest> registration;
#include "questionnaire_form_test.moc"
