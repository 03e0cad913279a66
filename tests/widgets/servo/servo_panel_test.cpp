// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/theme.h"
#include "widgets/servo/force_strip.h"
#include "widgets/servo/servo_panel.h"
#include "widgets/servo/servo_picture.h"
#include "widgets/servo/servo_texts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHelpEvent>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <QTranslator>

using namespace teleta::servo;

namespace {

ServoReport exploring() {
    ServoReport report;
    report.output.kind = TaskKind::explore;
    report.output.phase = 3;
    report.output.contact = ContactState::touching;
    report.output.edge = true;
    report.output.inverseJacobian = inverseTactileJacobian(true);
    report.output.projection = projectionMatrix(exploreTask(5.0, 0.005).projection);
    report.normalCompliance_mPerN = 1e-3;
    report.output.desired << -0.025, 0.0, 0.005, 0.0, 0.0, 0.0;
    report.output.actual << 0.001, 0.0, 0.0049, 0.0, 0.0002, 0.01;
    report.output.known.fill(true);
    const ServoPlan plan = explorePlan();
    report.tasks = plan.tasks.size();
    for (std::size_t i = 0; i < report.tasks; ++i)
        report.plan[i] = plan.tasks[i].kind;
    return report;
}

/// The table's titles in a language that needs more room.
class LongTitles : public QTranslator {
public:
    LongTitles() { QCoreApplication::installTranslator(this); }
    ~LongTitles() override { QCoreApplication::removeTranslator(this); }

    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char* context, const char* text, const char*, int) const override {
        if (QLatin1String(context) != QLatin1String("teleta::servo::ServoPicture"))
            return {};
        const QLatin1String source(text);
        return source == QLatin1String("Feature")   ? QStringLiteral("Caract\u00e9ristique")
               : source == QLatin1String("Desired") ? QStringLiteral("Souhait\u00e9e")
               : source == QLatin1String("Actual")  ? QStringLiteral("Mesur\u00e9e")
               : source == QLatin1String("Error")   ? QStringLiteral("\u00c9cart")
                                                    : QString();
    }
};

QString textOf(const ServoPanel& panel, const char* name) {
    return panel.findChild<QLabel*>(QLatin1String(name))->text();
}

QImage pictureOf(ServoPicture& picture) {
    picture.resize(picture.sizeHint());
    return picture.grab().toImage();
}

} // namespace

/// The panel of a running servo.
class ServoPanelTest : public QObject {
    Q_OBJECT

private slots:
    void theSceneIsRunHeldAndRestartedFromThePanel() {
        ServoPanel panel;
        panel.setStopEngaged(false);
        panel.setReport(exploring());
        QSignalSpy runs(&panel, &ServoPanel::runRequested);
        QSignalSpy restarts(&panel, &ServoPanel::restartRequested);
        const auto click = [&](const char* name) {
            QTest::mouseClick(panel.findChild<QPushButton*>(QLatin1String(name)), Qt::LeftButton);
        };
        click("servoHold");
        click("servoRun");
        click("servoRestart");
        QCOMPARE(runs.size(), 2);
        QVERIFY(!runs[0][0].toBool());
        QVERIFY(runs[1][0].toBool());
        QCOMPARE(restarts.size(), 1);
        panel.setStopEngaged(true);
        click("servoRun");
        click("servoRestart");
        QCOMPARE(runs.size(), 2);
        QCOMPARE(restarts.size(), 1);
        click("servoHold");
        QCOMPARE(runs.size(), 3);
    }

    void withoutAServoNothingCanBeChanged() {
        ServoPanel panel;
        QVERIFY(!panel.isEnabled());
        QCOMPARE(textOf(panel, "servoState"), QStringLiteral("No servo"));
    }

    void theVerdictIsToldAndThatOfTheRunBeforeARestart() {
        ServoPanel panel;
        panel.show();
        ServoReport report = exploring();
        panel.setReport(report);
        auto* verdict = panel.findChild<QLabel*>(QStringLiteral("servoVerdict"));
        QVERIFY(!verdict->isVisible());
        report.verdict = TaskVerdict{.completed = false,
                                     .phase = TaskKind::freeMotion,
                                     .reason = NotCompleted::stalled,
                                     .limit = Limit::jointEnd};
        panel.setReport(report);
        QVERIFY(verdict->isVisible());
        QCOMPARE(
            verdict->text(),
            QStringLiteral("So far: task not completed: stalled by the limit \u201cend of a joint\u201d"));
        ++report.restarts;
        report.verdict = TaskVerdict{};
        panel.setReport(report);
        QCOMPARE(verdict->text(),
                 QStringLiteral("So far: as planned\nLast run: task not completed: stalled by the limit "
                                "\u201cend of a joint\u201d"));
        panel.setReport(std::nullopt);
        QVERIFY(!verdict->isVisible());
    }

    void whatDiffersFromTheSceneIsNamedAndTakenBackByAButton() {
        ServoPanel panel;
        panel.resize(500, 900);
        panel.show();
        ServoReport report = exploring();
        panel.setReport(report);
        auto* changes = panel.findChild<QLabel*>(QStringLiteral("servoChanges"));
        auto* planned = panel.findChild<QPushButton*>(QStringLiteral("servoPlanned"));
        QVERIFY(!changes->isVisible() && !planned->isVisible());
        ServoTuning wished;
        connect(&panel, &ServoPanel::tuningChanged, &panel,
                [&](const ServoTuning& tuning) { wished = tuning; });
        panel.findChild<QDoubleSpinBox*>(QStringLiteral("servoForce"))->setValue(8.0);
        auto* moment = panel.findChild<QCheckBox*>(QStringLiteral("servoMoment"));
        QTest::mouseClick(moment, Qt::LeftButton, {}, QPoint(5, moment->height() / 2));
        QVERIFY(changes->isVisible());
        // After a restart, too.
        report.tuning = wished;
        ++report.restarts;
        panel.setReport(report);
        QVERIFY(changes->text().contains(QStringLiteral("force 5")));
        QVERIFY(changes->text().contains(QStringLiteral("moment balanced")));
        QTest::mouseClick(planned, Qt::LeftButton);
        QCOMPARE(wished, ServoTuning{});
        QVERIFY(!changes->isVisible() && !planned->isVisible());
        QCOMPARE(panel.findChild<QDoubleSpinBox*>(QStringLiteral("servoForce"))->value(), 5.0);
        QVERIFY(moment->isChecked());
    }

    void controlsStandAboveTheReadingsAndMatricesAreOpenedByTheirButton() {
        ServoPanel panel;
        panel.show();
        panel.setReport(exploring());
        panel.resize(panel.sizeHint());
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        const auto* picture = panel.findChild<ServoPicture*>();
        const auto* cost = panel.findChild<QLabel*>(QStringLiteral("servoCost"));
        for (const char* field : {"servoForce", "servoSlide", "servoGain", "servoMoment"})
            QVERIFY2(panel.findChild<QWidget*>(QLatin1String(field))->y() < picture->y(), field);
        const int closed = picture->minimumSizeHint().height();
        QTest::mouseClick(panel.findChild<QToolButton*>(QStringLiteral("servoMatrices")), Qt::LeftButton);
        QVERIFY(picture->minimumSizeHint().height() > closed + 6 * panel.fontMetrics().height());
        QTRY_VERIFY(picture->height() >= picture->minimumSizeHint().height());
        QVERIFY(cost->isVisible());
        QTest::mouseClick(panel.findChild<QToolButton*>(QStringLiteral("servoMatrices")), Qt::LeftButton);
        QCOMPARE(picture->minimumSizeHint().height(), closed);
    }

    void taskContactAndLimitsAreNamed() {
        ServoPanel panel;
        ServoReport report = exploring();
        panel.setReport(report);
        QVERIFY(panel.isEnabled());
        QCOMPARE(panel.findChild<QComboBox*>("servoTask")->currentText(), QStringLiteral("4. Explore"));
        QCOMPARE(textOf(panel, "servoState"), QStringLiteral("in contact"));
        QCOMPARE(textOf(panel, "servoLimits"), QStringLiteral("No limit acts."));
        report.recentLimits.set(Limit::force);
        report.recentLimits.set(Limit::deviation);
        panel.setReport(report);
        QCOMPARE(textOf(panel, "servoLimits"),
                 QStringLiteral("Limits that act: force, distance from the measured pose"));
        report.stopped = true;
        panel.setReport(report);
        QCOMPARE(panel.findChild<QComboBox*>("servoTask")->currentText(), QStringLiteral("4. Explore"));
        QCOMPARE(textOf(panel, "servoState"), QStringLiteral("STOP: the arm is held"));
    }

    void theRunningTaskIsNamedOnce() {
        ServoPanel panel;
        panel.setReport(exploring());
        for (const QLabel* label : panel.findChildren<QLabel*>())
            QVERIFY2(!label->text().contains(QStringLiteral("Explore")), qPrintable(label->text()));
    }

    void theForceHasATimeAxis() {
        ForceStrip strip;
        strip.resize(strip.sizeHint());
        const QImage picture = strip.grab().toImage();
        // Its words are under the plot, at the right end and in the left half.
        const auto inked = [&](double left, double right) {
            int count = 0;
            for (int y = picture.height() * 85 / 100; y < picture.height() * 92 / 100; ++y)
                for (int x = static_cast<int>(left * picture.width()); x < right * picture.width(); ++x)
                    count += picture.pixel(x, y) != picture.pixel(0, picture.height() - 1) ? 1 : 0;
            return count;
        };
        QVERIFY(inked(0.75, 1.0) > 0);
        QVERIFY(inked(0.15, 0.5) > 0);
    }

    void theForceIsKeptFor20sAndForgottenWithAnotherRun() {
        ForceStrip strip;
        strip.resize(strip.sizeHint());
        const QImage empty = strip.grab().toImage();
        ServoReport report = exploring();
        for (int i = 0; i <= 300; ++i) {
            report.time_s = 0.1 * i;
            strip.setReport(report);
            strip.setReport(report);
        }
        QCOMPARE(strip.steps(), std::size_t{201}); // both ends of 20 s
        const QImage picture = strip.grab().toImage();
        int inked = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = picture.width() / 4; x < picture.width(); ++x)
                inked += picture.pixel(x, y) != empty.pixel(x, y) ? 1 : 0;
        QVERIFY(inked > picture.width() / 3); // a level line
        ++report.restarts;
        strip.setReport(report);
        QCOMPARE(strip.steps(), std::size_t{1});
        strip.setReport(std::nullopt);
        QCOMPARE(strip.steps(), std::size_t{0});
    }

    void whatACycleTakesIsToldWhenItIsKnown() {
        ServoPanel panel;
        ServoReport report = exploring();
        panel.setReport(report);
        QVERIFY(textOf(panel, "servoCost").isEmpty());
        report.rate_Hz = 1000.0;
        report.times.cycles = 2;
        report.times.of(CyclePart::contact) = 12e-6;
        report.times.of(CyclePart::dynamics) = 8e-6;
        panel.setReport(report);
        QCOMPARE(
            textOf(panel, "servoCost"),
            QStringLiteral("Simulated cycle: 10.0\u00a0\u00b5s, 100 times real time. Contact 60\u00a0%, "
                           "kinematics 0\u00a0%, features 0\u00a0%, control 0\u00a0%, dynamics 40\u00a0%."));
    }

    void aServoThatIsNotRealSaysSo() {
        ServoPanel panel;
        panel.setProvenance(teleta::base::Provenance::simulated);
        panel.setReport(exploring());
        const auto* stripe = panel.findChild<teleta::base::ProvenanceStripe*>();
        QVERIFY(stripe != nullptr && !stripe->isHidden());
        QCOMPARE(stripe->accessibleName(), QStringLiteral("SIMULATED"));
    }

    void everyFieldHasItsName() {
        ServoPanel panel;
        for (const char* name : {"servoForce", "servoSlide", "servoGain", "servoTask"}) {
            auto* field = panel.findChild<QWidget*>(QLatin1String(name));
            bool named = false;
            for (const QLabel* label : panel.findChildren<QLabel*>())
                named = named || (label->buddy() == field && !label->text().isEmpty());
            QVERIFY2(named, name);
        }
    }

    void everyLimitAndTaskHasWords() {
        for (std::size_t i = 0; i < kLimits; ++i)
            QVERIFY(!ServoTexts::limit(static_cast<Limit>(i)).isEmpty());
        for (int kind = 0; kind <= static_cast<int>(TaskKind::comanipulation); ++kind)
            QVERIFY(!ServoTexts::task(static_cast<TaskKind>(kind)).isEmpty());
    }

    void aTypedForceIsPostedWhenItIsWhole() {
        ServoPanel panel;
        panel.setReport(exploring());
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        QSignalSpy spy(&panel, &ServoPanel::tuningChanged);
        auto* force = panel.findChild<QDoubleSpinBox*>(QStringLiteral("servoForce"));
        force->setFocus();
        force->selectAll();
        QTest::keyClicks(force, QStringLiteral("7"));
        QCOMPARE(spy.count(), 0);
        QTest::keyClick(force, Qt::Key_Return);
        QCOMPARE(spy.count(), 1);
        QCOMPARE(spy.front().front().value<ServoTuning>().force_N, 7.0);
        QCOMPARE(spy.front().front().value<ServoTuning>().slide_mPerS, 0.005);
    }

    void aWishStaysOnTheScreenUntilTheServoHasTakenIt() {
        ServoPanel panel;
        ServoReport report = exploring();
        panel.setReport(report);
        auto* moment = panel.findChild<QCheckBox*>(QStringLiteral("servoMoment"));
        QVERIFY(moment->isChecked());
        moment->click();
        panel.setReport(report); // not yet in use
        QVERIFY(!moment->isChecked());
        report.tuning.moment = false;
        panel.setReport(report);
        QVERIFY(!moment->isChecked());
        report.tuning.moment = true; // another hand
        panel.setReport(report);
        QVERIFY(moment->isChecked());
    }

    void whatIsShownCausesNoWish() {
        ServoPanel panel;
        QSignalSpy tuning(&panel, &ServoPanel::tuningChanged);
        QSignalSpy task(&panel, &ServoPanel::taskRequested);
        ServoReport report = exploring();
        panel.setReport(report);
        report.tuning = {8.0, 0.002, 2.0, false};
        report.output.phase = 1;
        panel.setReport(report);
        QCOMPARE(tuning.count(), 0);
        QCOMPARE(task.count(), 0);
        QCOMPARE(panel.findChild<QDoubleSpinBox*>(QStringLiteral("servoForce"))->value(), 8.0);
        QCOMPARE(panel.findChild<QComboBox*>(QStringLiteral("servoTask"))->currentIndex(), 1);
    }

    void aTaskIsChosenByTheKeyboard() {
        ServoPanel panel;
        panel.setReport(exploring());
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        auto* tasks = panel.findChild<QComboBox*>(QStringLiteral("servoTask"));
        QCOMPARE(tasks->count(), 5);
        QSignalSpy spy(&panel, &ServoPanel::taskRequested);
        tasks->setFocus();
        QTest::keyClick(tasks, Qt::Key_Up);
        QCOMPARE(spy.count(), 1);
        QCOMPARE(spy.front().front().value<std::size_t>(), std::size_t{2});
    }

    void aSceneThatWantsMoreThanUsualIsShownAsItIs() {
        ServoPanel panel;
        ServoReport report = exploring();
        const ServoPlan plan = explorePlan(25.0, 0.08);
        report.tuning = tuningOf(plan);
        report.bounds = boundsOf(plan);
        panel.setReport(report);
        QCOMPARE(panel.findChild<QDoubleSpinBox*>(QStringLiteral("servoForce"))->value(), 25.0);
        QCOMPARE(panel.findChild<QDoubleSpinBox*>(QStringLiteral("servoSlide"))->value(), 80.0);
        QSignalSpy spy(&panel, &ServoPanel::tuningChanged);
        panel.findChild<QCheckBox*>(QStringLiteral("servoMoment"))->click();
        QCOMPARE(spy.count(), 1);
        QCOMPARE(spy.front().front().value<ServoTuning>().force_N, 25.0);
    }

    void aWishChangesNothingElse() {
        ServoPanel panel;
        ServoReport report = exploring();
        report.tuning.force_N = 5.25; // more digits than its field has
        panel.setReport(report);
        QSignalSpy spy(&panel, &ServoPanel::tuningChanged);
        panel.findChild<QCheckBox*>(QStringLiteral("servoMoment"))->click();
        QCOMPARE(spy.count(), 1);
        const auto wish = spy.front().front().value<ServoTuning>();
        QCOMPARE(wish.force_N, 5.25);
        QVERIFY(!wish.moment);
    }

    /// Erratum 1: an undefined feature is shown as undefined, not as 0.
    void whatIsNotDefinedIsADash() {
        ServoPicture picture;
        ServoReport report = exploring();
        report.output.known = {true, true, true, false, false, false}; // a single taxel
        picture.setReport(report);
        const auto texts = [&](int row) {
            std::array<QString, 3> shown = picture.featureTexts(row);
            for (QString& text : shown)
                text.remove(QChar(0x2007)); // keeps the width
            return shown;
        };
        QCOMPARE(texts(kX)[1], QStringLiteral("1.00"));
        QCOMPARE(texts(kZ)[1], QStringLiteral("4.90"));
        QCOMPARE(texts(kZ)[2], QStringLiteral("0.10"));
        for (const int row : {kWx, kWy, kWz}) {
            QCOMPARE(texts(row)[0], QStringLiteral("0.00"));
            QCOMPARE(texts(row)[1], QStringLiteral("\u2014"));
            QCOMPARE(texts(row)[2], QStringLiteral("\u2014"));
        }
    }

    /// The paper's (8) with beta = 1 and 0, and its projection of phase IV with erratum 3 and 5.
    void theMatricesAreThoseOfThePaper() {
        const auto rows = [](std::initializer_list<const char*> texts) {
            QStringList list;
            for (const char* text : texts)
                list << QString::fromUtf8(text);
            return list;
        };
        QCOMPARE(ServoPicture::matrixTexts(inverseTactileJacobian(true)),
                 rows({"1 0 0 0 0 0", "0 1 0 0 0 0", "0 0 1 0 0 0", "0 \u22121 0 1 0 0", "\u22121 0 0 0 1 0",
                       "0 0 0 0 0 1"}));
        QCOMPARE(
            ServoPicture::matrixTexts(inverseTactileJacobian(false)),
            rows({"1 0 0 0 0 0", "0 1 0 0 0 0", "0 0 1 0 0 0", "0 0 0 1 0 0", "0 0 0 0 1 0", "0 0 0 0 0 0"}));
        QCOMPARE(
            ServoPicture::matrixTexts(projectionMatrix(exploreTask(5.0, 0.005).projection)),
            rows({"1 0 0 0 0 0", "0 1 0 0 0 0", "0 0 1 0 0 0", "0 0 0 0 0 0", "0 0 0 0 1 0", "0 0 0 0 0 1"}));
    }

    void everyTitleIsWholeWhereThereIsRoomAndCutWithItsWholeTextAtTheMouseWhereThereIsNot() {
        LongTitles translator;
        const QStringList whole{QStringLiteral("Caract\u00e9ristique"), QStringLiteral("Souhait\u00e9e"),
                                QStringLiteral("Mesur\u00e9e"), QStringLiteral("\u00c9cart")};
        ServoPicture picture;
        picture.setReport(exploring());
        picture.resize(picture.sizeHint());
        for (const auto& title : picture.shownTitles())
            QVERIFY(whole.contains(title));
        QVERIFY(picture.sizeHint().width() >= picture.minimumSizeHint().width());

        picture.resize(picture.minimumSizeHint().width() / 2, picture.height());
        picture.show();
        QVERIFY(QTest::qWaitForWindowExposed(&picture));
        const QString cut = picture.shownTitles()[0];
        QVERIFY(cut != whole[0]);
        QVERIFY(cut.endsWith(QChar(0x2026)));
        const QPoint onTitle(teleta::base::em(&picture, 1), teleta::base::em(&picture, 0.6));
        QHelpEvent help(QEvent::ToolTip, onTitle, picture.mapToGlobal(onTitle));
        QCoreApplication::sendEvent(&picture, &help);
        QCOMPARE(QToolTip::text(), whole[0]);
        QToolTip::hideText();
    }

    void thePictureShowsOtherMatricesForAPointThanForAnEdge() {
        ServoPicture picture;
        picture.showMatrices(true);
        const QImage empty = pictureOf(picture);
        picture.setReport(exploring());
        const QImage edge = pictureOf(picture);
        ServoReport report = exploring();
        report.output.inverseJacobian = inverseTactileJacobian(false);
        picture.setReport(report);
        const QImage point = pictureOf(picture);
        QVERIFY(edge != empty);
        QVERIFY(point != edge);
    }
};

namespace {
const teleta::test::Registration<ServoPanelTest> registration;
}
#include "servo_panel_test.moc"
