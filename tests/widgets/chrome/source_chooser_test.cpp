// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/source_chooser.h"

#include <QComboBox>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTranslator>

using teleta::base::Provenance;
using teleta::chrome::SourceChooser;

/// Choosing and opening sources.
class SourceChooserTest : public QObject {
    Q_OBJECT

private slots:
    void choosesAmongTheOpenSources() {
        SourceChooser chooser;
        chooser.setSources(
            {{7, "first", Provenance::simulated, false}, {9, "second", Provenance::recorded, false}}, 9);
        auto* box = chooser.findChild<QComboBox*>();
        QCOMPARE(box->count(), 2);
        QCOMPARE(box->currentIndex(), 1);
        QVERIFY(box->itemData(0, Qt::AccessibleTextRole).toString().contains("SIMULATED"));
        const auto* badge = chooser.findChild<teleta::base::ProvenanceBadge*>();
        QVERIFY(!badge->isHidden());
        QCOMPARE(badge->provenance(), Provenance::recorded); // of the source that is shown
        QCOMPARE(badge->accessibleName(), QString("RECORDED"));
        QCOMPARE(box->accessibleDescription(), QString("RECORDED"));
        QSignalSpy choices(&chooser, &SourceChooser::sourceChosen);
        QTest::keyClick(box, Qt::Key_Up);
        QCOMPARE(choices.size(), 1);
        QCOMPARE(choices[0][0].toULongLong(), 7ULL);
    }

    void theClosedBoxSpeaksTheLanguageOfNow() {
        SourceChooser chooser;
        chooser.setSources({{7, "first", Provenance::simulated, false}}, 7);
        const auto* box = chooser.findChild<QComboBox*>();
        QCOMPARE(box->accessibleDescription(), QString("SIMULATED"));
        struct French : QTranslator {
            bool isEmpty() const override { return false; }
            QString translate(const char*, const char* text, const char*, int) const override {
                return QLatin1String(text) == QLatin1String("SIMULATED") ? QStringLiteral("SIMULATION")
                                                                         : QString();
            }
        } translator;
        QCoreApplication::installTranslator(&translator);
        QTRY_COMPARE(box->accessibleDescription(), QString("SIMULATION"));
        QCoreApplication::removeTranslator(&translator);
        chooser.setSources({{7, "first", Provenance::live, false}}, 7);
        QCOMPARE(box->accessibleDescription(), QString());
    }

    void saysThatThereIsNoSource() {
        SourceChooser chooser;
        chooser.setSources({}, 0);
        QVERIFY(!chooser.findChild<QComboBox*>()->isEnabled());
        QVERIFY(!chooser.findChild<QComboBox*>()->currentText().isEmpty());
    }

    void offersDemosFilesAndRecentOnes() {
        SourceChooser chooser;
        chooser.setDemos({{":/scenes/demo.toml", "A demo", "what it shows", "A group"}});
        chooser.setRecent({"/somewhere/run.csv"});
        QSignalSpy demos(&chooser, &SourceChooser::demoRequested);
        QSignalSpy recordings(&chooser, &SourceChooser::openRecordingRequested);
        QSignalSpy recent(&chooser, &SourceChooser::recentRequested);
        for (QAction* action : chooser.openMenu()->actions()) {
            if (!action->isSeparator() && !action->text().contains("list") &&
                !action->text().contains("scene file"))
                action->trigger();
        }
        QCOMPARE(demos.size(), 1);
        QCOMPARE(demos[0][0].toString(), QString(":/scenes/demo.toml"));
        QCOMPARE(recordings.size(), 1);
        QCOMPARE(recent.size(), 1);
        QCOMPARE(recent[0][0].toString(), QString("/somewhere/run.csv"));
    }

    void theMenuTellsRecordingsByWhatIsInThem() {
        SourceChooser chooser;
        chooser.setRecent({"/a/20261129T102231Z-x.teleta", "/a/20261129T104201Z-x.teleta", "/b/run.csv"});
        chooser.setRecentNames(
            {{"/a/20261129T102231Z-x.teleta", {"touches & more", "2026-11-29 10:22, 8 s", {}}},
             {"/a/20261129T104201Z-x.teleta", {"touches & more", "2026-11-29 10:42, 8 s", {}}}});
        const QList<QAction*> actions = chooser.openMenu()->actions();
        const qsizetype first = actions.size() - 3;
        QCOMPARE(actions[first]->text(), QString("touches && more, 2026-11-29 10:22, 8 s"));
        QCOMPARE(actions[first + 1]->text(), QString("touches && more, 2026-11-29 10:42, 8 s"));
        QCOMPARE(actions[first + 2]->text(), QString("run.csv"));
        QCOMPARE(actions[first]->toolTip(), QString("/a/20261129T102231Z-x.teleta"));
    }

    void closesTheSourceThatIsShown() {
        SourceChooser chooser;
        chooser.setSources({{7, "first", Provenance::simulated, false}}, 7);
        QSignalSpy closes(&chooser, &SourceChooser::closeRequested);
        for (auto* button : chooser.findChildren<QToolButton*>()) {
            if (button->menu() == nullptr)
                QTest::mouseClick(button, Qt::LeftButton);
        }
        QCOMPARE(closes.size(), 1);
        QCOMPARE(closes[0][0].toULongLong(), 7ULL);
    }
};

QTEST_MAIN(SourceChooserTest)
#include "source_chooser_test.moc"
