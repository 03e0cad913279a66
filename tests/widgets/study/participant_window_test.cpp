// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/study/participant/answer_button.h"
#include "widgets/study/participant/answer_keys.h"
#include "widgets/study/participant/participant_window.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

using namespace teleta;
using study::AnswerButton;
using study::ParticipantScene;
using study::ParticipantWindow;
using State = ParticipantScene::State;

Q_DECLARE_METATYPE(teleta::study::KeyPress)

namespace {

/// A touch screen that the test touches.
QPointingDevice* touchScreen() {
    static QPointingDevice* device = QTest::createTouchDevice();
    return device;
}

/// How often a widget is painted.
class PaintCount : public QObject {
public:
    explicit PaintCount(QWidget& widget) { widget.installEventFilter(this); }
    bool eventFilter(QObject* /*watched*/, QEvent* event) override {
        count += event->type() == QEvent::Paint ? 1 : 0;
        return false;
    }
    int count = 0;
};

} // namespace

class ParticipantWindowTest : public QObject {
    Q_OBJECT

    std::int64_t m_now = 5;
    std::unique_ptr<ParticipantWindow> m_window;
    std::vector<study::KeyPress> m_presses;
    std::vector<std::pair<QString, QString>> m_releases;

private slots:
    void init() {
        m_presses.clear();
        m_releases.clear();
        m_window = std::make_unique<ParticipantWindow>([this] { return m_now; });
        std::vector<study::AnswerChoice> choices;
        for (const char* letter : {"A", "B", "C", "D", "E", "F"})
            choices.push_back({letter, QString(letter).toLower(), {}});
        m_window->setChoices(std::move(choices));
        connect(m_window.get(), &ParticipantWindow::pressed, this,
                [this](const study::KeyPress& press) { m_presses.push_back(press); });
        connect(m_window.get(), &ParticipantWindow::released, this,
                [this](const QString& device, const QString& key) { m_releases.emplace_back(device, key); });
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup() { m_window.reset(); }

    void stampsAPressWithTheTimeOfItsArrivalAndThePhysicalKey() {
        m_now = 1234;
        QTest::keyClick(m_window.get(), Qt::Key_3);
        QCOMPARE(m_presses.size(), std::size_t(1));
        QCOMPARE(m_presses[0].time_ns, std::int64_t(1234));
        QCOMPARE(m_presses[0].response, std::optional<std::size_t>(2));
        QCOMPARE(m_presses[0].device, std::string("keyboard"));
        QCOMPARE(m_presses[0].key, std::string("Digit3"));
        QCOMPARE(m_releases.size(), std::size_t(1));
        QCOMPARE(m_releases[0].second, QStringLiteral("Digit3"));
    }

    void yesAndNoHaveLettersOfTheirOwn() {
        m_window->setChoices({{"yes", "yes", {}, false, "Y"}, {"no", "no", {}, false, "N"}});
        QTest::keyClick(m_window.get(), Qt::Key_Y);
        QTest::keyClick(m_window.get(), Qt::Key_N);
        QTest::keyClick(m_window.get(), Qt::Key_2);
        QTest::keyClick(m_window.get(), Qt::Key_S); // of another design
        QCOMPARE(m_presses.size(), std::size_t(3));
        QCOMPARE(m_presses[0].response, std::optional<std::size_t>(0));
        QCOMPARE(m_presses[0].key, std::string("KeyY"));
        QCOMPARE(m_presses[1].response, std::optional<std::size_t>(1));
        QCOMPARE(m_presses[1].device, std::string("keyboard"));
        QCOMPARE(m_presses[2].response, std::optional<std::size_t>(1));
        QCOMPARE(m_presses[2].key, std::string("Digit2"));
        QCOMPARE(m_releases.size(), std::size_t(3));
    }

    void theIntervalThatIsFeltLightsUp() {
        m_window->setChoices({{"1", "1", {}, false}, {"2", "2", {}, false}});
        ParticipantScene scene;
        scene.state = State::stimulus;
        scene.question = "Which one?";
        const auto looks = [this] {
            return std::vector{m_window->buttons()[0]->look(), m_window->buttons()[1]->look()};
        };
        using Look = AnswerButton::Look;
        m_window->setScene(scene);
        QCOMPARE(looks(), (std::vector{Look::plain, Look::plain}));
        scene.interval = 2;
        m_window->setScene(scene);
        QCOMPARE(looks(), (std::vector{Look::plain, Look::lit}));
        QCOMPARE(m_window->instruction(), QStringLiteral("2"));
        scene.interval = 0;
        scene.state = State::answering;
        scene.answersOpen = true;
        m_window->setScene(scene);
        QCOMPARE(looks(), (std::vector{Look::plain, Look::plain}));
        QCOMPARE(m_window->instruction(), QStringLiteral("Which one?"));
    }

    void aDigitWithoutAnAnswerIsNoAnswer() {
        QTest::keyClick(m_window.get(), Qt::Key_8);
        QCOMPARE(m_presses.size(), std::size_t(1));
        QVERIFY(!m_presses[0].response);
        QTest::keyClick(m_window.get(), Qt::Key_A);
        QTest::keyClick(m_window.get(), Qt::Key_0);
        QCOMPARE(m_presses.size(), std::size_t(1));
    }

    void shortcutsAreNoAnswers() {
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::ControlModifier);
        QVERIFY(m_presses.empty());
    }

    void answersOnTheWayDownOfTheMouse() {
        AnswerButton* button = m_window->buttons()[4];
        QTest::mousePress(m_window.get(), Qt::LeftButton, {}, button->geometry().center());
        QCOMPARE(m_presses.size(), std::size_t(1));
        QCOMPARE(m_presses[0].response, std::optional<std::size_t>(4));
        QCOMPARE(m_presses[0].device, std::string("mouse"));
        QCOMPARE(m_presses[0].key, std::string("button E"));
        QVERIFY(m_releases.empty());
        QTest::mouseRelease(m_window.get(), Qt::LeftButton, {}, button->geometry().center());
        QCOMPARE(m_releases.size(), std::size_t(1));
        QTest::mouseClick(m_window.get(), Qt::RightButton, {}, button->geometry().center());
        QCOMPARE(m_presses.size(), std::size_t(1));
    }

    void answersByTouchOnce() {
        AnswerButton* button = m_window->buttons()[1];
        QTest::touchEvent(m_window.get(), touchScreen())
            .press(0, button->geometry().center(), m_window.get());
        QTest::touchEvent(m_window.get(), touchScreen())
            .release(0, button->geometry().center(), m_window.get());
        QCOMPARE(m_presses.size(), std::size_t(1));
        QCOMPARE(m_presses[0].response, std::optional<std::size_t>(1));
        QCOMPARE(m_presses[0].device, std::string("touch"));
        QCOMPARE(m_releases.size(), std::size_t(1));
    }

    void spaceAsksForTheNextTrialButNotByItself() {
        QSignalSpy next(m_window.get(), &ParticipantWindow::nextRequested);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QCOMPARE(next.count(), 1);
        QKeyEvent held(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, QStringLiteral(" "), true);
        QApplication::sendEvent(m_window.get(), &held);
        QCOMPARE(next.count(), 1);
    }

    void aPressBesideTheButtonsGoesOnOnlyWhenThereIsSomethingToGoOnTo() {
        QSignalSpy next(m_window.get(), &ParticipantWindow::nextRequested);
        QTest::mouseClick(m_window.get(), Qt::LeftButton, {}, QPoint(3, 3));
        QCOMPARE(next.count(), 0);
        m_window->setScene({.state = State::ready, .trials = 3});
        QTest::mouseClick(m_window.get(), Qt::LeftButton, {}, QPoint(3, 3));
        QCOMPARE(next.count(), 1);
        m_window->setScene({.state = State::answering, .answersOpen = true});
        QTest::mouseClick(m_window.get(), Qt::LeftButton, {}, QPoint(3, 3));
        QCOMPARE(next.count(), 1);
    }

    void letsGoOfKeysWhenItIsClosed() {
        QSignalSpy left(m_window.get(), &ParticipantWindow::left);
        QTest::keyPress(m_window.get(), Qt::Key_2);
        m_window->close();
        QCOMPARE(left.count(), 1);
        QCOMPARE(m_releases.size(), std::size_t(1));
        QCOMPARE(m_releases[0].second, QStringLiteral("Digit2"));
    }

    void showsTheRightAnswerInFeedbackOnly() {
        ParticipantScene scene{.state = State::feedback, .diagrams = true, .answered = 0, .presented = 3};
        m_window->setScene(scene);
        QCOMPARE(m_window->buttons()[0]->look(), AnswerButton::Look::wrong);
        QCOMPARE(m_window->buttons()[3]->look(), AnswerButton::Look::right);
        scene.answered = 3;
        m_window->setScene(scene);
        QCOMPARE(m_window->buttons()[3]->look(), AnswerButton::Look::right);
        scene = {.state = State::ready, .trials = 30, .answered = 3};
        m_window->setScene(scene);
        QCOMPARE(m_window->buttons()[3]->look(), AnswerButton::Look::chosen);
        scene.state = State::stimulus;
        scene.answersOpen = true;
        m_window->setScene(scene);
        for (const AnswerButton* button : m_window->buttons()) {
            QCOMPARE(button->look(), AnswerButton::Look::plain);
            QVERIFY(button->isOpen());
        }
    }

    void stopIsSeenInTheWholeWindow() {
        const auto reds = [&] {
            const QImage image = m_window->grab().toImage();
            int count = 0;
            for (int x = 0; x < image.width(); ++x)
                count += image.pixelColor(x, 1) == base::statusColours(m_window->palette()).stop ? 1 : 0;
            return count;
        };
        m_window->setScene({.state = State::ready});
        QCOMPARE(reds(), 0);
        m_window->setScene({.state = State::stopped});
        QVERIFY(reds() > m_window->width() / 2);
        QVERIFY(m_window->instruction().contains(QStringLiteral("Stopped")));
    }

    void theMarkOfAPilotIsSeen() {
        m_window->setScene({.state = State::ready, .mode = study::Mode::run});
        const QImage real = m_window->grab().toImage();
        m_window->setScene({.state = State::ready, .mode = study::Mode::pilot});
        QVERIFY(m_window->grab().toImage() != real);
    }

    void whatAnAnswerChangesIsPaintedBeforeTheNextEvent() {
        m_window->setScene({.state = State::answering, .trials = 4, .answersOpen = true, .diagrams = true});
        QCoreApplication::processEvents();
        PaintCount window(*m_window);
        PaintCount right(*m_window->buttons()[1]);
        m_window->setScene(
            {.state = State::feedback, .trials = 4, .diagrams = true, .answered = 1, .presented = 1});
        QCOMPARE(right.count, 0);
        m_window->paintNow();
        QCOMPARE(right.count, 1);
        // It is not painted a second time later, nor when nothing changed.
        QCoreApplication::processEvents();
        m_window->paintNow();
        QCOMPARE(right.count, 1);
        QCOMPARE(window.count, 1);
    }

    void picturesThatAreKeptFollowSizePaletteAndMode() {
        const auto choices = [] {
            return std::vector<study::AnswerChoice>{
                {"A", "a", study::diagramOf(*pattern::findBuiltIn("shape.A.dynamic"), 2.0)},
                {"B", "b", study::diagramOf(*pattern::findBuiltIn("shape.B.dynamic"), 2.0)}};
        };
        const auto show = [](ParticipantWindow& window, QSize size, study::Mode mode) {
            window.setScene({.state = State::answering, .mode = mode, .answersOpen = true, .diagrams = true});
            window.resize(size);
            return window.grab().toImage();
        };
        const auto fresh = [&](QSize size, study::Mode mode) {
            ParticipantWindow window([] { return std::int64_t{0}; });
            window.setChoices(choices());
            return show(window, size, mode);
        };
        m_window->setChoices(choices());
        const QSize small(800, 600);
        const QSize large(1000, 700);
        // The edges of large letters are rounded a little otherwise in a window that was shown.
        const auto differing = [](const QImage& a, const QImage& b) {
            if (a.size() != b.size())
                return 1.0;
            int count = 0;
            for (int y = 0; y < a.height(); ++y)
                for (int x = 0; x < a.width(); ++x)
                    count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
            return count / (1.0 * a.width() * a.height());
        };
        constexpr double kRounding = 0.0005;
        const auto follows = [&](QSize size, study::Mode mode) {
            return differing(show(*m_window, size, mode), fresh(size, mode)) < kRounding;
        };
        QVERIFY(follows(small, study::Mode::pilot));
        QVERIFY(follows(large, study::Mode::pilot));
        QVERIFY(follows(large, study::Mode::simulated));
        QVERIFY(follows(large, study::Mode::run));
        QVERIFY(differing(fresh(large, study::Mode::simulated), fresh(large, study::Mode::pilot)) >
                kRounding);
        base::applyTheme(base::ThemeChoice::dark);
        QCoreApplication::processEvents(); // the windows are told
        const bool followsTheme = follows(large, study::Mode::pilot);
        base::applyTheme(base::ThemeChoice::light);
        QVERIFY(followsTheme);
    }

    void aDiagramIsThatOfThePattern() {
        const auto diagram = [](const char* id) { return study::diagramOf(*pattern::findBuiltIn(id), 2.0); };
        // All six tactors at once for the static circle, one after another for the dynamic one.
        for (const int turn : diagram("shape.A.static").turn)
            QCOMPARE(turn, 0);
        auto turns = diagram("shape.A.dynamic").turn;
        std::sort(turns.begin(), turns.end());
        QCOMPARE(turns, (std::array{1, 2, 3, 4, 5, 6}));
        // The hardest material is an impulse of 0.3 s in 2 s.
        const auto impulse = diagram("stiffness.E.dynamic");
        const auto on = static_cast<double>(std::count_if(impulse.course.begin(), impulse.course.end(),
                                                          [](const auto& at) { return at[0] > 0.0; }));
        QVERIFY(std::abs(on / double(impulse.kColumns) - 0.15) < 0.03);
        // Static levels rise from 1/2 to 1.
        QVERIFY(std::abs(diagram("stiffness.A.static").strongest[0] - 0.5) < 1e-9);
        QVERIFY(std::abs(diagram("stiffness.E.static").strongest[5] - 1.0) < 1e-9);
    }
};

static const test::Registration<ParticipantWindowTest> registration;
#include "participant_window_test.moc"
